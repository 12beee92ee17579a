// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The twin's clipped scheme itself, on cases worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "tests/reference/brute_force/brute_force.h"
#include "tests/shifted_pose.h"

namespace pcm::brute_force {
namespace {

using Point = std::array<double, 3>;

Answer clipped_answer(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose, Mode mode) {
  return answer(E, F, pose, reference::Problem::exact, mode, Scheme::clipped);
}

TriangleMesh box(double x, double y, double z) {
  return generate::box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(x, y, z));
}

double total_area(const Answer& a) {
  double sum = 0;
  for (const Element& element : a.elements) sum += element_area(a.scene, element);
  return sum;
}

constexpr Mode kModes[] = {Mode::E, Mode::F, Mode::both};

TEST(ClippedBruteForce, BoxOnPlateCarriesItsFootprintTimesItsDepth) {
  // F = [0.25, 1.75]^2 x [1.5, 3.5] in E = [0, 2]^3, 0.5 deep: of either surface the square of 2.25 sees the other; F's
  // flanks and E's see nothing, for their lines leave the other body through faces beyond their own body's.
  for (const Mode mode : kModes) {
    const Answer a = clipped_answer(box(2, 2, 2), box(1.5, 1.5, 2), shifted(0.25, 0.25, 1.5), mode);
    EXPECT_EQ(total_area(a), mode == Mode::both ? 4.5 : 2.25);
    for (const Element& element : a.elements) {
      EXPECT_EQ(penetration(a.scene, element), 0.5);
      EXPECT_EQ(greatest_penetration(a.scene, element), 0.5);
      EXPECT_EQ(element_position(a.scene, element)[2], 1.75);
    }
    const ForceAndTorque load = elastic_force(a, 8, mode);
    EXPECT_EQ(load.force, (Point{0, 0, -9}));                 // 8 * 2.25 * 0.5, pressing E down
    EXPECT_EQ(load.torque, (Point{0.75 * -9, 0.75 * 9, 0}));  // about F's corner, 0.75 from the middle in x and y
  }
}

TEST(ClippedBruteForce, FlushFlanksCarryNothing) {
  // [0, 2]^2 x [1, 3] against [0, 2]^3: top against bottom, 4 * 1. The flanks' lines meet the other's at distance zero.
  for (const Mode mode : kModes) {
    const Answer a = clipped_answer(box(2, 2, 2), box(2, 2, 2), shifted(0, 0, 1), mode);
    EXPECT_EQ(total_area(a), mode == Mode::both ? 8 : 4);
    EXPECT_EQ(elastic_force(a, 1, mode).force, (Point{0, 0, -4}));
  }
}

TEST(ClippedBruteForce, RestingAndIdenticalBoxesCarryNothing) {
  for (const Mode mode : kModes) {
    EXPECT_TRUE(clipped_answer(box(2, 2, 2), box(1, 1, 1), shifted(0.5, 0.5, 2), mode).elements.empty());
    EXPECT_TRUE(clipped_answer(box(2, 2, 2), box(2, 2, 2), {}, mode).elements.empty());
  }
}

TEST(ClippedBruteForce, PlateThinnerThanThePenetrationGivesNoForce) {
  // The top of a plate 0.25 thick, pressed by 0.5: its lines leave the plate first. The box's lines meet the plate's
  // top.
  const TriangleMesh plate = generate::plate(4, 4, 0.25);
  EXPECT_TRUE(clipped_answer(plate, box(1, 1, 2), shifted(0.125, 0.25, -0.5), Mode::E).elements.empty());
  const Answer a = clipped_answer(plate, box(1, 1, 2), shifted(0.125, 0.25, -0.5), Mode::F);
  EXPECT_EQ(total_area(a), 0);  // they enter the plate through its bottom
}

TEST(ClippedBruteForce, PlaneMasterCarriesTheVolume) {
  // A8. The spike's tip is 5/8 below the plate's top; the twin has its volume from elsewhere.
  const TriangleMesh plate = generate::plate(4, 4, 1);
  const Answer a = clipped_answer(plate, degenerate::spike(), shifted(0.125, 0.0625, -0.625), Mode::E);
  ASSERT_TRUE(a.volume.has_value());
  EXPECT_GT(*a.volume, 0);
  EXPECT_EQ(elastic_force(a, 1, Mode::E).force, (Point{0, 0, -*a.volume}));
}

TEST(ClippedBruteForce, KeelInPlateHasItsMeanAndGreatestPenetration) {
  // The keel's flanks z = |y|, at 45 degrees, with the plate's top at z = 1/2: their lines keep x and leave the keel
  // below the top where |x| > 1/2. So either flank sees the top over |x| <= 1/2, 0 <= z <= 1/2, an area of sqrt2 / 2,
  // with u = sqrt2 (1/2 - z) of the mean sqrt2 / 4; its share of the vertical force is sqrt2 / 2 * sqrt2 / 4 / sqrt2.
  const Answer a = clipped_answer(degenerate::keel(), generate::plate(8, 8, 4), shifted(0, 0, 0.5), Mode::E);
  ASSERT_FALSE(a.elements.empty());
  for (const Element& element : a.elements) {
    EXPECT_LT(element.q, element.q_greatest);
    EXPECT_EQ(greatest_penetration(a.scene, element), std::sqrt(0.5));
  }
  EXPECT_EQ(total_area(a), std::sqrt(2));
  EXPECT_EQ(elastic_force(a, 1, Mode::E).force, (Point{0, 0, std::sqrt(0.125)}));
}

TEST(ClippedBruteForce, KeelIsClampedPointByPoint) {
  // On the same flanks the integral of min(u, 1/4) is sqrt2 / 8 - 1/32, the greatest u what it was; the perimeter is
  // that of a rectangle 1 m by sqrt2 / 2, wherever the clamp divides it.
  const Answer a = answer(degenerate::keel(), generate::plate(8, 8, 4), shifted(0, 0, 0.5), reference::Problem::exact,
                          Mode::E, Scheme::clipped, 0.25);
  double integral = 0, perimeter = 0;
  for (const Element& element : a.elements) {
    integral += element_area(a.scene, element) * penetration(a.scene, element);
    EXPECT_EQ(greatest_penetration(a.scene, element), std::sqrt(0.5));
    perimeter += Rational(element.perimeter * a.scene.unit).get_d();
  }
  EXPECT_DOUBLE_EQ(integral, 2 * (std::sqrt(2) / 8 - 1.0 / 32));
  EXPECT_EQ(a.elements.size(),
            clipped_answer(degenerate::keel(), generate::plate(8, 8, 4), shifted(0, 0, 0.5), Mode::E).elements.size());
  EXPECT_GT(perimeter, 4 + 2 * std::sqrt(2) - 1e-12);
}

}  // namespace
}  // namespace pcm::brute_force
