// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/surface/clearance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/parts.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"

namespace pcm::fast {
namespace {

using Line = Eigen::ParametrizedLine<double, 3>;

std::array<Eigen::Vector3d, 3> points_of(const PreparedSurface& surface, Index face) {
  const Triangle& t = surface.face(face);
  return {surface.vertex(t[0]), surface.vertex(t[1]), surface.vertex(t[2])};
}

/// Where the line passes through the triangle's interior, by how far along it; NaN where it does not.
double passage(const Line& line, const std::array<Eigen::Vector3d, 3>& f) {
  double sides[3];
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = line.direction().dot((f[k] - line.origin()).cross(f[(k + 1) % 3] - line.origin()));
  }
  const bool through = (sides[0] > 0 && sides[1] > 0 && sides[2] > 0) || (sides[0] < 0 && sides[1] < 0 && sides[2] < 0);
  if (!through) return std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d N = (f[1] - f[0]).cross(f[2] - f[0]);
  return N.dot(f[0] - line.origin()) / N.dot(line.direction());
}

/// Random lines through random faces, within their cones, against all other faces.
void expect_lines_clear(const TriangleMesh& mesh, unsigned seed) {
  SCOPED_TRACE(mesh.name + ", seed " + std::to_string(seed));
  const Surface surface(mesh);
  const PreparedSurface& data = surface.data();
  const double max_coordinate = data.max_coordinates.maxCoeff();
  std::mt19937 random(seed);
  std::uniform_real_distribution<> uniform;
  for (int i = 0; i < 2000; ++i) {
    const auto face = static_cast<Index>(uniform(random) * static_cast<double>(mesh.faces.size()));
    const auto p = points_of(data, face);
    const Eigen::Vector3d n = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    const double s = std::sqrt(uniform(random)), t = uniform(random);
    const std::size_t cone = uniform(random) < 0.5 ? 0 : 1;
    const double greatest = std::acos(kConeCosine[cone]);
    const double angle = (uniform(random) < 0.5 ? 0.999 : uniform(random)) * greatest;
    const Eigen::Vector3d across = n.cross(Eigen::Vector3d(1, 2, 3)).normalized();
    const Eigen::Vector3d tilted =
        Eigen::AngleAxisd(6.283 * uniform(random), n) * (Eigen::AngleAxisd(angle, across) * n).eval();
    const Line up((1 - s) * p[0] + s * ((1 - t) * p[1] + t * p[2]), tilted);
    const Clearance clear = clearance(data, face);
    const double beneath = static_cast<double>(clear.beneath[cone]) * max_coordinate / std::cos(angle);
    for (Index other = 0; other < static_cast<Index>(mesh.faces.size()); ++other) {
      if (other == face) continue;
      const double met = passage(up, points_of(data, other));
      ASSERT_FALSE(met <= 0 && -met < beneath) << face << " " << other << " " << met << " " << beneath;
      ASSERT_FALSE(met >= 0 && clear.above[cone]) << face << " " << other << " " << met;
    }
  }
}

TEST(Clearance, LinesWithinAConeMeetNothingNearer) {
  expect_lines_clear(generate::bubble(), 1);
  expect_lines_clear(generate::bumpy_sphere(1, 0.1, 6, 40, 26), 2);
  expect_lines_clear(generate::icosphere(1, 3), 3);
  expect_lines_clear(generate::socket(1, 0.5, 24, 6), 4);
  expect_lines_clear(generate::box({1, 2, 0.1}), 5);
}

TEST(Clearance, SphereIsClearFarBeneathAndEverywhereAbove) {
  const Surface sphere(generate::icosphere(2, 4));
  for (Index face = 0; face < static_cast<Index>(sphere.mesh().faces.size()); ++face) {
    const Clearance clear = clearance(sphere.data(), face);
    EXPECT_GT(clear.beneath[1], 0.15);
    EXPECT_LT(clear.beneath[1], 0.5);
    EXPECT_GE(clear.beneath[0], clear.beneath[1]);
    EXPECT_TRUE(clear.above[0] && clear.above[1]);
  }
}

TEST(Clearance, BoxIsNotClearBesideItsEdges) {
  const Surface box(generate::box({1, 1, 1}));
  for (Index face = 0; face < static_cast<Index>(box.mesh().faces.size()); ++face) {
    const Clearance clear = clearance(box.data(), face);
    EXPECT_EQ(clear.beneath[1], 0);
    EXPECT_TRUE(clear.above[1]);
  }
}

}  // namespace
}  // namespace pcm::fast
