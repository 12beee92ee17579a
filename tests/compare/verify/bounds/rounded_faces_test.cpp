// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/rounded_faces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <random>

namespace pcm::compare {
namespace {

TriangleMesh tetrahedron(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  TriangleMesh mesh;
  mesh.vertices = {a, b, c, (a + b + c) / 4 + Eigen::Vector3d(0, 0, 0x1p52)};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 3}};
  return mesh;
}

/// Face 0 of E runs through the origin, v and w. A corner of face 0 of F lies `corner` above v + w, the two others lie
/// `others` above v and w, m.
bool straddles(const Eigen::Vector3d& v, const Eigen::Vector3d& w, double corner, double others) {
  const Eigen::Vector3d up = (v.cross(w).z() > 0 ? 1 : -1) * Eigen::Vector3d::UnitZ();
  const TriangleMesh mesh_E = tetrahedron(Eigen::Vector3d::Zero(), v, w);
  const TriangleMesh mesh_F = tetrahedron(v + w + corner * up, v + others * up, w + others * up);
  const SurfaceFeatures E(mesh_E), F(mesh_F);
  const ContactLaw law;
  return RoundedFaces({E, F, law, Mode::E, Scheme::clipped, {}, {}}).straddles(Side::E, 0, Side::F, 0);
}

/// Coordinates are integers of 51 bits, so that sums are exact; a height of 1 is far below what the roundings of their
/// products make.
TEST(RoundedFaces, AFaceStraddlesAPlaneThatItsCornersLieOnBothSidesOfByAnUlp) {
  std::mt19937_64 random(1);
  SCOPED_TRACE("seed 1");
  const auto vector = [&] {
    const auto coordinate = [&] {
      return static_cast<double>(static_cast<std::int64_t>(random() >> 13) - (1LL << 50));
    };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return Eigen::Vector3d(x, y, z);
  };
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d v = vector(), w = vector();
    EXPECT_TRUE(straddles(v, w, 1, -1)) << i;
    EXPECT_TRUE(straddles(v, w, -1, 1)) << i;
    for (const double others : {-1.0, 0.0, 1.0}) {
      EXPECT_FALSE(straddles(v, w, 0, others)) << i;
      EXPECT_FALSE(straddles(v, w, others, others)) << i;
    }
  }
}

}  // namespace
}  // namespace pcm::compare
