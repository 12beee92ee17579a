// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/generate/loft.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/meshes/generate/generator_expectations.h"

namespace pcm::generate {
namespace {

TEST(Loft, EqualCirclesWithRoundEndsGiveACapsule) {
  const auto rings = rounded_rings(-1, 1, {0.25, 4}, {0.25, 4}, 13);
  ASSERT_EQ(rings.size(), 13u);
  const std::vector<CrossSection> sections{{-1, 0, 0, 0.25, 0.25, 0}, {1, 0, 0, 0.25, 0.25, 0}};
  for (const LoftAxis axis : {LoftAxis::x, LoftAxis::z}) {
    const TriangleMesh mesh = loft("capsule", axis, sections, rings, 12);
    test::expect_closed(mesh, 2 * 12 * 13);
    for (const Eigen::Vector3d& p : mesh.vertices) {
      const double along = axis == LoftAxis::x ? p.x() : p.z();
      const double beyond = std::max(std::fabs(along) - 0.75, 0.0);
      const double across = std::sqrt(std::max(p.squaredNorm() - along * along, 0.0));
      EXPECT_NEAR(std::hypot(beyond, across), 0.25, 1e-14);
    }
  }
}

TEST(Loft, PassesThroughItsSectionsAndDoesNotOvershoot) {
  const std::vector<CrossSection> sections{{0, 0, 0, 0.1, 0.1, 0}, {1, 0.2, 0, 0.4, 0.1, 0}, {2, 0.2, 0, 0.2, 0.1, 0}};
  std::vector<LoftRing> rings;
  for (int i = 1; i < 20; ++i) rings.push_back({i / 10.0, 1});
  const TriangleMesh mesh = loft("bulge", LoftAxis::z, sections, rings, 8);
  test::expect_closed(mesh, 2 * 8 * 19);
  double greatest = 0;
  for (const Eigen::Vector3d& p : mesh.vertices) greatest = std::max(greatest, p.x());
  EXPECT_NEAR(greatest, 0.6, 1e-15);
  EXPECT_EQ(mesh.vertices[1 + 9 * 8].x(), greatest) << "the ring at the middle section";
}

TEST(Loft, FullySquareSectionFollowsTheSuperellipse) {
  const std::vector<CrossSection> sections{{0, 0, 0, 2, 1, 1}, {1, 0, 0, 2, 1, 1}};
  const TriangleMesh mesh = loft("square", LoftAxis::z, sections, {{0.25, 1}, {0.75, 1}}, 16);
  for (std::size_t i = 1; i + 1 < mesh.vertices.size(); ++i) {
    const Eigen::Vector3d& p = mesh.vertices[i];
    EXPECT_NEAR(std::pow(p.x() / 2, 8) + std::pow(p.y(), 8), 1, 1e-13);
  }
}

}  // namespace
}  // namespace pcm::generate
