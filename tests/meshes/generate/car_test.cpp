// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/generate/car.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "pcm/check.h"
#include "reference/proofs/self_intersections.h"
#include "tests/meshes/generate/generator_expectations.h"

namespace pcm::generate {
namespace {

TEST(Car, IsAClosedBodyOf1240Faces) {
  const TriangleMesh mesh = car();
  test::expect_closed(mesh, 1240);
  EXPECT_TRUE(check(mesh).fit());
  EXPECT_TRUE(reference::self_intersections(mesh).empty());
}

TEST(Car, HasTheStatedExtentsAndIsSymmetric) {
  const TriangleMesh mesh = car();
  Eigen::Vector3d lowest = mesh.vertices[0], highest = mesh.vertices[0];
  std::set<std::array<double, 3>> points;
  for (const Eigen::Vector3d& p : mesh.vertices) {
    lowest = lowest.cwiseMin(p);
    highest = highest.cwiseMax(p);
    points.insert({p.x(), p.y(), p.z()});
  }
  EXPECT_EQ(lowest.x(), 0);
  EXPECT_EQ(highest.x(), 4.4);
  EXPECT_NEAR(highest.y(), 0.87, 1e-3);
  EXPECT_NEAR(lowest.z(), 0.22, 0.01);
  EXPECT_NEAR(highest.z(), 1.45, 0.01);
  for (const auto& [x, y, z] : points) EXPECT_TRUE(points.contains({x, 0.0 - y, z})) << x << ' ' << y << ' ' << z;
}

/// Height of the upper outline at x, between the vertices of the plane y = 0.
double upper_outline(const TriangleMesh& mesh, double x) {
  Eigen::Vector3d before(-1, 0, 0), after(10, 0, 0);
  for (const Eigen::Vector3d& p : mesh.vertices) {
    if (std::fabs(p.y()) > 1e-12 || p.z() < 0.5) continue;
    if (p.x() <= x && p.x() > before.x()) before = p;
    if (p.x() >= x && p.x() < after.x()) after = p;
  }
  if (after.x() == before.x()) return before.z();
  return before.z() + (after.z() - before.z()) * (x - before.x()) / (after.x() - before.x());
}

TEST(Car, SideViewHasBonnetWindscreenRoofAndBoot) {
  const TriangleMesh mesh = car();
  constexpr std::array<std::array<double, 2>, 5> kOutline{
      {{0.15, 0.75}, {1.15, 0.95}, {1.95, 1.42}, {3.20, 1.40}, {3.90, 1.05}}};
  for (const auto& [x, z] : kOutline) EXPECT_NEAR(upper_outline(mesh, x), z, 0.02) << "at x = " << x;
}

}  // namespace
}  // namespace pcm::generate
