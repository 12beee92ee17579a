// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts whose areas are worked out on paper. Polygons and all else that is discrete are held against the twin.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/round.h"
#include "reference/oracle.h"
#include "tests/reference/brute_force/brute_force.h"
#include "tests/reference/oracle_combinatorics.h"
#include "tests/reference/problems.h"
#include "tests/shifted_pose.h"

namespace pcm::brute_force {
namespace {

using reference::kProblems;
using reference::Problem;

/// The oracle's answer, after its combinatorics have been held against the twin's.
reference::Answer answer_held_by_twin(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose, Problem problem) {
  const reference::Answer oracle = reference::Oracle(E, F).answer(problem, pose);
  EXPECT_EQ(difference(combinatorics_of(answer(E, F, pose, problem)), combinatorics_of(oracle)), "");
  return oracle;
}

TriangleMesh box(double x0, double y0, double z0, double x1, double y1, double z1) {
  return generate::box(Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1));
}

TEST(WorkedCases, TorusOnPlateHasARingPatch) {
  // Four segments by four: a ring with the section |rho - 2| + |z| <= 1, rho = |x| + |y|. The plate's top, one half of
  // a length above the ring's lowest edge, cuts it between rho = 3/2 and rho = 5/2.
  //   Plate: squares rho <= s have the area 2 s^2: 2 (25/4 - 9/4) = 8.
  //   Torus: four trapezoids outside with parallel sides 2 sqrt2 and 5/2 sqrt2, four inside with 2 sqrt2 and 3/2 sqrt2,
  //   all of the height sqrt((1/2)^2 / 2 + (1/2)^2) = sqrt(3/8): (9 + 7) sqrt2 sqrt(3/8) = 8 sqrt3.
  //   Volume: at the height t above the lowest edge the ring's area is 2 ((2 + t)^2 - (2 - t)^2) = 16 t: 16 / 8 = 2.
  const TriangleMesh torus = generate::torus(2, 1, 4, 4);
  const TriangleMesh plate = generate::plate(20, 20, 5);
  for (const Problem problem : kProblems) {
    const reference::Answer a = answer_held_by_twin(torus, plate, shifted(0, 0, -0.5), problem);
    EXPECT_EQ(a.polygons.size(), 2u);
    EXPECT_EQ(a.patches, 1);
    EXPECT_EQ(a.E.area, 8 * std::sqrt(3.0));
    EXPECT_EQ(a.F.area, 8);
    EXPECT_EQ(a.E.vector_area_Me, Eigen::Vector3d(0, 0, -8));
    EXPECT_EQ(a.F.vector_area_Me, Eigen::Vector3d(0, 0, 8));
    EXPECT_EQ(a.volume, 2);
  }
}

TEST(WorkedCases, TwoFeetInOneLargeFaceAreTwoPatches) {
  // Two unit cubes as one surface, a quarter deep in the plate's top, both on the same side of its diagonal.
  //   Each foot: 1 + 4 / 4 = 2; on the plate 1; volume 1/4.
  const TriangleMesh feet = degenerate::joined(box(4, -4, -0.25, 5, -3, 0.75), box(7, -4, -0.25, 8, -3, 0.75));
  const TriangleMesh plate = generate::plate(20, 20, 5);
  for (const Problem problem : kProblems) {
    const reference::Answer a = answer_held_by_twin(feet, plate, {}, problem);
    EXPECT_EQ(a.polygons.size(), 2u);
    EXPECT_EQ(a.patches, 2);
    EXPECT_EQ(a.F.intersected.size(), 1u);
    EXPECT_TRUE(a.F.inner.empty());
    EXPECT_EQ(a.E.area, 4);
    EXPECT_EQ(a.F.area, 2);
    EXPECT_EQ(a.volume, 0.5);
  }
}

TEST(WorkedCases, RingUponWallHasTwoPatches) {
  // A wall runs along y under the lying ring of the first case and meets two of its arms.
  //   Wall |x| <= 1/4, top half a length above the ring's lowest edge. At the height t above it and for given x, the
  //   ring covers 2 - t - |x| <= |y| <= 2 + t - |x|: the width 2 t in y on either side, whatever x.
  //   Wall's top (t = 1/2): 2 arms x 1/2 x 1 = 1. Wall's two flanks at |x| = 1/4: 2 arms x the triangle below t = 1/2:
  //   1/2 x 1/2 x 1 = 1/4 each: 4 x 1/4 = 1. So F = 2, volume 1/2 x 2 x 1/4 = 1/4.
  //   Ring: surfaces |y| = 2 +- t - |x|, gradient (1, 1, 1) in (x, y, t) up to sign: area sqrt3 times its projection on
  //   (x, t), 1/2 x 1/2 for each of 2 x 2: sqrt3.
  const TriangleMesh ring = generate::torus(2, 1, 4, 4);
  const TriangleMesh wall = box(-0.25, -8, -5, 0.25, 8, -0.5);
  for (const Problem problem : kProblems) {
    const reference::Answer a = answer_held_by_twin(ring, wall, {}, problem);
    EXPECT_EQ(a.polygons.size(), 2u);
    EXPECT_EQ(a.patches, 2);
    EXPECT_EQ(a.E.area, std::sqrt(3.0));
    EXPECT_EQ(a.F.area, 2);
    EXPECT_EQ(a.volume, 0.25);
  }
}

TEST(WorkedCases, PyramidsInsideOneLargeFaceAreClippedWithoutAVertexOfIt) {
  // An octahedron |x| + |y| + |z| <= 1 dips by 1/2 into one face. On the plate |x| + |y| <= 1/2: 2 / 4 = 1/2; on the
  // octahedron sqrt3 times as much; volume 1/3 x 1/2 x 1/2 = 1/12.
  const TriangleMesh octahedron{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
      "octahedron"};
  const TriangleMesh plate = generate::plate(20, 20, 5);
  const Pose pose = shifted(-4, 4, -0.5);  // the octahedron is at (4, -4) on the plate
  for (const Problem problem : kProblems) {
    const reference::Answer a = answer_held_by_twin(octahedron, plate, pose, problem);
    EXPECT_EQ(a.polygons.size(), 1u);
    EXPECT_EQ(a.F.intersected.size(), 1u);
    EXPECT_EQ(a.E.area, std::sqrt(3.0) / 2);
    EXPECT_EQ(a.F.area, 0.5);
    EXPECT_EQ(a.volume, 1.0 / 12);
  }
}

TEST(WorkedCases, OpenContainerAgainstBubble) {
  // The container's walls rise 3 on 4; turned by that angle about x, one of them lies in the plane z = 0 of the
  // bubble's frame and the bubble stands on it, its pole a depth h below. Its polar cap is a pyramid over a regular
  // 25-gon of circumradius rho, height H > h, so the polygon is that 25-gon scaled by s = h / H.
  //   Wall: s^2 25/2 rho^2 sin(2 pi / 25). Cap: s^2 times 25 triangles of base 2 rho sin(pi / 25) and height
  //   sqrt(H^2 + rho^2 cos^2(pi / 25)).
  //   The bubble at the angle t from its axis, t = pi / 20 at the first of its rings, is (length / 3)(1 + cos(2 t) / 2)
  //   away from the origin.
  const double length = 0.4;
  const double pole = length / 2;
  const TriangleMesh bubble = generate::bubble(length);
  const double t = std::numbers::pi / 20;
  const double distance = length / 3 * (1 + std::cos(2 * t) / 2);
  const double rho = distance * std::sin(t);
  const double height = pole - distance * std::cos(t);
  const double h = height / 4;

  // The wall towards +y of the container is z = 3/4 y: it comes into the plane z = 0 by turning about x by -atan(3/4).
  // The point (0, 0.5, 0.375) of it goes under the pole.
  Pose pose;
  pose.A << 1, 0, 0, 0, 0.8, 0.6, 0, -0.6, 0.8;
  pose.r = Eigen::Vector3d(0, 0, -pole + h) - pose.A * Eigen::Vector3d(0, 0.5, 0.375);
  const double s = h / height;
  const double wall_area = s * s * 12.5 * rho * rho * std::sin(2 * std::numbers::pi / 25);
  const double cap_area =
      s * s * 25 * rho * std::sin(std::numbers::pi / 25) * std::hypot(height, rho * std::cos(std::numbers::pi / 25));
  // 0.6 and 0.8 are off by 1e-17, the heights by a few 1e-17 m, of h = 1e-3 m: a relative 1e-12 is ample.
  for (const Problem problem : kProblems) {
    const reference::Answer a = answer_held_by_twin(bubble, generate::pyramid(2, 0.75), pose, problem);
    ASSERT_EQ(a.polygons.size(), 1u);
    EXPECT_TRUE(a.polygons.front().closed);
    EXPECT_EQ(a.polygons.front().points.size(), 25u);
    EXPECT_FALSE(a.ambiguous);
    EXPECT_FALSE(a.volume.has_value());
    EXPECT_EQ(a.E.intersected.size(), 25u);
    EXPECT_NEAR(a.E.area, cap_area, 1e-12 * cap_area);
    EXPECT_NEAR(a.F.area, wall_area, 1e-12 * wall_area);
  }
}

TEST(WorkedCases, IdenticalBodiesAtTheIdentityPoseShareTheirSurface) {
  // All of the surface is covered by faces of equal normals: they count in E's area only. Cube of edge 1: 6, volume 1.
  for (const TriangleMesh& cube : {box(0, 0, 0, 1, 1, 1), generate::gridded_box({0, 0, 0}, {1, 1, 1}, {2, 2, 2})}) {
    for (const Problem problem : kProblems) {
      const reference::Answer a = answer_held_by_twin(cube, cube, {}, problem);
      EXPECT_EQ(a.E.area, 6);
      EXPECT_EQ(a.E.area_interval.open, 0);
      EXPECT_EQ(a.E.area_interval.closed, 6);
      EXPECT_EQ(a.F.area, 0);
      EXPECT_EQ(a.F.area_interval.open, 0);
      EXPECT_EQ(a.F.area_interval.closed, 6);
      EXPECT_EQ(a.volume, 1);
    }
  }
}

TEST(WorkedCases, StackedBoxesHaveAnIntervalOfAreas) {
  // A box 2 x 3 in plan upon one of 4 x 4, rim clear of rim: between nothing and 6, by the convention nothing.
  const TriangleMesh lower = box(0, 0, 0, 4, 4, 1);
  const TriangleMesh upper = box(1, 0.5, 1, 3, 3.5, 2);
  for (const Problem problem : kProblems) {
    const reference::Answer a = answer_held_by_twin(lower, upper, {}, problem);
    for (const reference::ActiveArea& active : {a.E, a.F}) {
      EXPECT_EQ(active.area, 0);
      EXPECT_EQ(active.area_interval.open, 0);
      EXPECT_EQ(active.area_interval.closed, 6);
    }
    EXPECT_EQ(a.volume, 0);
  }
}

TEST(WorkedCases, BoxesStackedFlushAndSunkHaveEqualFlanks) {
  // The same plan 2 x 3, the upper one sunk by 1/2: E's top (6) and F's bottom (6) lie inside; the flanks' common band
  // 1/2 x 10 = 5 has equal normals and counts in E's.
  const TriangleMesh lower = box(0, 0, 0, 2, 3, 1);
  const TriangleMesh upper = box(0, 0, 0.5, 2, 3, 1.5);
  for (const Problem problem : kProblems) {
    const reference::Answer a = answer_held_by_twin(lower, upper, {}, problem);
    EXPECT_EQ(a.E.area, 11);
    EXPECT_EQ(a.E.area_interval.open, 6);
    EXPECT_EQ(a.E.area_interval.closed, 11);
    EXPECT_EQ(a.F.area, 6);
    EXPECT_EQ(a.F.area_interval.open, 6);
    EXPECT_EQ(a.F.area_interval.closed, 11);
    EXPECT_EQ(a.volume, 3);
  }
}

}  // namespace
}  // namespace pcm::brute_force
