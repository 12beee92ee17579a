// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle against its brute-force twin on small meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "reference/oracle.h"
#include "tests/reference/brute_force/combinatorics.h"
#include "tests/reference/brute_force/twin_comparison.h"
#include "tests/reference/oracle_combinatorics.h"

namespace pcm::brute_force {
namespace {

using reference::Problem;

constexpr double kStiffness = 1e6;

/// Where the other surface is open, only the oracle has a rule for faces in its plane.
bool comparable(const Answer& twin, Side side) {
  if (twin.scene.body(other(side)).closed) return true;
  return std::ranges::all_of(twin.active(side).shares,
                             [](const Share& share) { return share.equal == 0 && share.opposite == 0; });
}

Eigen::Vector3d eigen(const std::array<double, 3>& x) {
  return {x[0], x[1], x[2]};
}

/// Both sides promise the true value, correctly rounded: equal to the last bit.
void expect_same_area(const ActiveArea& twin, const reference::ActiveArea& oracle) {
  EXPECT_EQ(twin.area, oracle.area);
  EXPECT_EQ(twin.open, oracle.area_interval.open);
  EXPECT_EQ(twin.closed, oracle.area_interval.closed);
  EXPECT_EQ(eigen(twin.vector_area), oracle.vector_area_Me);
}

/// The twin sweeps over the crossings' places, the oracle adds coplanar overlaps by the side they are moved to.
void expect_same_limit_area(const ActiveArea& twin, const reference::ActiveArea& oracle) {
  EXPECT_EQ(twin.perturbed_area, oracle.limit_area);
  EXPECT_EQ(eigen(twin.perturbed_vector_area), oracle.limit_vector_area_Me);
}

/// Which components of force and torque differ from the twin's; empty where none does.
std::string difference_of_loads(const ForceAndTorque& twin, const Eigen::Vector3d& force,
                                const Eigen::Vector3d& torque) {
  std::ostringstream difference;
  difference << std::setprecision(17);
  for (int i = 0; i < 3; ++i) {
    if (twin.force[i] != force[i]) difference << "force " << i << ": " << twin.force[i] << ", not " << force[i] << "; ";
    if (twin.torque[i] != torque[i])
      difference << "torque " << i << ": " << twin.torque[i] << ", not " << torque[i] << "; ";
  }
  return difference.str();
}

void expect_same_elements(const Answer& twin, const reference::Answer& oracle) {
  ASSERT_EQ(twin.elements.size(), oracle.elements.size());
  double greatest = 0;
  for (std::size_t i = 0; i < twin.elements.size(); ++i) {
    const double u = penetration(twin.scene, twin.elements[i]);
    EXPECT_EQ(u, oracle.elements[i].penetration);
    EXPECT_EQ(element_area(twin.scene, twin.elements[i]), oracle.elements[i].area);
    EXPECT_EQ(u, oracle.elements[i].greatest_penetration);
    EXPECT_EQ(oracle.elements[i].perimeter, 0);
    greatest = std::max(greatest, u);
  }
  EXPECT_EQ(greatest, oracle.max_penetration);
  EXPECT_EQ(difference_of_loads(elastic_force(twin, kStiffness, Mode::both), oracle.force_Me, oracle.torque_Me), "");
}

void expect_same(const Answer& twin, const reference::Answer& oracle) {
  const Combinatorics expected = combinatorics_of(twin);
  Combinatorics found = combinatorics_of(oracle);
  const bool E_comparable = comparable(twin, Side::E);
  const bool F_comparable = comparable(twin, Side::F);
  if (!E_comparable || !F_comparable) found.undefined_areas = expected.undefined_areas;
  EXPECT_EQ(difference(expected, found), "");
  if (E_comparable) expect_same_area(twin.E, oracle.E);
  if (F_comparable) expect_same_area(twin.F, oracle.F);
  expect_same_limit_area(twin.E, oracle.E);
  expect_same_limit_area(twin.F, oracle.F);
  if (twin.perturbed_volume.has_value()) {
    EXPECT_EQ(twin.perturbed_volume, oracle.volume);
  }
  EXPECT_EQ(twin.volume, oracle.volume);
  for (const reference::Polygon& polygon : oracle.polygons)
    for (const reference::Crossing& c : polygon.points) {
      const Vector& x = twin.positions.at({c.edge_side, c.edge, c.face});
      for (int i = 0; i < 3; ++i) EXPECT_EQ(rounded(Rational(x[i] * twin.scene.unit)), c.position_Me[i]);
    }
  expect_same_elements(twin, oracle);
}

Answer compare(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose) {
  ContactLaw law;
  law.stiffness = kStiffness;
  const reference::Oracle oracle(E, F, law, Mode::both);
  const auto compare_on = [&](Problem problem) {
    SCOPED_TRACE(problem == Problem::rounded ? "rounded problem" : "exact problem");
    Answer twin = answer(E, F, pose, problem, Mode::both);
    expect_same(twin, oracle.answer(problem, pose));
    return twin;
  };
  compare_on(Problem::exact);
  return compare_on(Problem::rounded);
}

TEST(BruteTwin, AgreesOnTheDegenerateCatalogue) {
  compare_on_catalogue(compare);
}

TEST(BruteTwin, AgreesWhereFacesLieInAPocket) {
  compare_in_a_pocket(compare);
}

TEST(BruteTwin, AgreesOnAnElementWithAForceHalfwayBetweenTwoDoubles) {
  const Trial trial = draw_trial(Kind::open, 888, 88);
  compare(trial.E, trial.F, trial.pose);
  ContactLaw law;
  law.stiffness = kStiffness;
  const reference::Oracle oracle(trial.E, trial.F, law, Mode::both);
  for (const Problem problem : {Problem::rounded, Problem::exact}) {
    const std::vector<reference::Element> elements = oracle.answer(problem, trial.pose).elements;
    Answer twin = answer(trial.E, trial.F, trial.pose, problem, Mode::both);
    const std::vector<Element> found = std::exchange(twin.elements, {});
    ASSERT_EQ(found.size(), elements.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      twin.elements = {found[i]};
      EXPECT_EQ(eigen(elastic_force(twin, kStiffness, Mode::E).force), elements[i].force_Me);
    }
  }
}

/// Rounded to 45 bits: 8 less than a double has.
Eigen::Vector3d eight_bits_less(const Eigen::Vector3d& x) {
  return x.unaryExpr([](double component) {
    int exponent = 0;
    const double mantissa = std::frexp(component, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(mantissa, 45)), exponent - 45);
  });
}

TEST(BruteTwin, NoticesAnOracleEightBitsLessPrecise) {
  ContactLaw law;
  law.stiffness = kStiffness;
  int noticed = 0;
  for (int number = 0; number < affordable(40); ++number) {
    const Trial trial = draw_trial(Kind::generic, 20, number);
    SCOPED_TRACE(trial.description);
    const Answer twin = answer(trial.E, trial.F, trial.pose, Problem::exact, Mode::both);
    if (twin.elements.empty()) continue;
    const reference::Answer oracle =
        reference::Oracle(trial.E, trial.F, law, Mode::both).answer(Problem::exact, trial.pose);
    const ForceAndTorque truth = elastic_force(twin, kStiffness, Mode::both);
    EXPECT_EQ(difference_of_loads(truth, oracle.force_Me, oracle.torque_Me), "");
    EXPECT_NE(difference_of_loads(truth, eight_bits_less(oracle.force_Me), oracle.torque_Me), "");
    EXPECT_NE(difference_of_loads(truth, oracle.force_Me, eight_bits_less(oracle.torque_Me)), "");
    ++noticed;
  }
  EXPECT_GE(noticed, affordable(40) / 8);
}

class BruteTwinPoses : public testing::TestWithParam<Series> {};

TEST_P(BruteTwinPoses, AgreeWithTheOracle) {
  compare_on_trials(GetParam(), 20, compare);
}

INSTANTIATE_TEST_SUITE_P(Kinds, BruteTwinPoses, kAllSeries, series_name);

}  // namespace
}  // namespace pcm::brute_force
