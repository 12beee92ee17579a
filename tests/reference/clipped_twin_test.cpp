// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle's clipped scheme against the brute-force twin's on small meshes, both problems.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/oracle.h"
#include "tests/reference/brute_force/twin_comparison.h"

namespace pcm::brute_force {
namespace {

using reference::Problem;

constexpr double kStiffness = 1e6;

/// Surfaces of more faces are left out: boundaries grow as the square of the faces, the twin's work as their cube.
constexpr std::size_t kMostFaces = 48;

Eigen::Vector3d eigen(const std::array<double, 3>& x) {
  return {x[0], x[1], x[2]};
}

/// Both sides promise the true values, correctly rounded: equal to the last bit.
void expect_same_element(const Answer& twin, const Element& expected, const reference::Element& found) {
  EXPECT_EQ(element_area(twin.scene, expected), found.area);
  EXPECT_EQ(penetration(twin.scene, expected), found.penetration);
  EXPECT_EQ(greatest_penetration(twin.scene, expected), found.greatest_penetration);
  // The twin's comes from its strips, of whose sides some are longer than the part is wide; GMP truncates to a double.
  const double perimeter = Rational(expected.perimeter * twin.scene.unit).get_d();
  EXPECT_NEAR(perimeter, found.perimeter, 1e-10 * perimeter + std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(eigen(element_position(twin.scene, expected)), found.position_Me);
  EXPECT_EQ(eigen(element_force(twin.scene, expected, kStiffness)), found.force_Me);
}

std::string names(const auto& elements) {
  std::string result;
  for (const auto& element : elements)
    result += (element.master == Side::E ? " E" : " F") + std::to_string(element.master_face) + '/' +
              std::to_string(element.slave_face);
  return result;
}

void expect_same(const Answer& twin, const reference::Answer& oracle) {
  EXPECT_EQ(twin.too_deep, oracle.too_deep);
  ASSERT_EQ(names(twin.elements), names(oracle.elements));
  double greatest = 0;
  for (std::size_t i = 0; i < twin.elements.size(); ++i) {
    expect_same_element(twin, twin.elements[i], oracle.elements[i]);
    greatest = std::max(greatest, greatest_penetration(twin.scene, twin.elements[i]));
  }
  EXPECT_EQ(greatest, oracle.max_penetration);
  const ForceAndTorque load = elastic_force(twin, kStiffness, Mode::both);
  EXPECT_EQ(eigen(load.force), oracle.force_Me);
  EXPECT_EQ(eigen(load.torque), oracle.torque_Me);
}

Answer compare(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) {
  if (std::max(E.faces.size(), F.faces.size()) > kMostFaces) return {};
  ContactLaw law;
  law.stiffness = kStiffness;
  const reference::Oracle oracle(E, F, law, Mode::both, Scheme::clipped);
  Wanted wanted;
  wanted.polygons = false;
  wanted.areas = false;
  const auto compare_on = [&](Problem problem) {
    SCOPED_TRACE(problem == Problem::rounded ? "rounded problem" : "exact problem");
    Answer twin = answer(E, F, pose, problem, Mode::both, Scheme::clipped);
    expect_same(twin, oracle.answer(problem, pose, {}, wanted));
    return twin;
  };
  compare_on(Problem::exact);
  return compare_on(Problem::rounded);
}

/// Two boxes of whole or nearly whole corners, one of either at a height of t. Parts of their faces are of the size of
/// t, which enclosures of any fixed number of bits lose.
void compare_boxes_with_a_corner_at(double t) {
  SCOPED_TRACE(t);
  const double two = std::nextafter(2.0, 3.0), below = std::nextafter(1.0, 0.0), beyond = std::nextafter(-1.0, -2.0);
  TriangleMesh E, F;
  E.vertices = {{1, two, 2}, {below, 1, -1}, {beyond, -2, 1}, {2, 1, beyond},
                {-1, 0, 2},  {-1, -1, 0},    {-1, -1, t},     {-1, 2, 2}};
  E.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 4}, {1, 7, 6},
             {1, 6, 2}, {0, 4, 7}, {0, 7, 1}, {3, 2, 6}, {3, 6, 5}};
  F.vertices = {{-1, -1, -1}, {2, two, -1}, {0, 0, 1},     {2, two, 2},
                {-1, 2, 0},   {1, -1, 0},   {t, 1, below}, {-1, -2, -2}};
  F.faces = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}, {0, 3, 5}, {0, 5, 4},
             {1, 7, 6}, {1, 6, 2}, {0, 4, 7}, {0, 7, 1}, {3, 2, 6}, {3, 6, 5}};
  Pose pose;
  pose.A << 0, -1, 0, 0, 0, 1, -1, 0, 0;
  const Answer twin = compare(E, F, pose);
  EXPECT_GT(twin.elements.size(), 4u);
}

TEST(ClippedTwin, AgreesOnCoordinatesThatEnclosuresLose) {
  for (const int exponent : {-240, -1074}) compare_boxes_with_a_corner_at(std::ldexp(1, exponent));
}

TEST(ClippedTwin, AgreesOnTheDegenerateCatalogue) {
  compare_on_catalogue(compare);
}

class ClippedTwinPoses : public testing::TestWithParam<Series> {};

TEST_P(ClippedTwinPoses, AgreeWithTheOracle) {
  compare_on_trials(GetParam(), 60, compare);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ClippedTwinPoses, kAllSeries, series_name);

}  // namespace
}  // namespace pcm::brute_force
