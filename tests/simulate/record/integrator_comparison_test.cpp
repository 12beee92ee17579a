// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/run/integrator_comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "simulate/record/integrator_comparison_report.h"
#include "simulate/scenes/read_scene.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/simulate/scenes/built_in_scene.h"

namespace pcm::simulate {
namespace {

/// The block that creeps from 0.13 s on.
Scene shortly_creeping() {
  Scene scene = built_in_scene("creep");
  scene.duration = 0.3;
  return scene;
}

const IntegratorComparison& comparison() {
  static const IntegratorComparison compared =
      compare_integrators(shortly_creeping(), {{"bdf", Method::bdf}, {"dormand_prince", Method::dormand_prince}},
                          [](const std::string&) {});
  return compared;
}

TEST(IntegratorComparison, TriesEveryIntegratorOverToleranceAndSlipVelocity) {
  const IntegratorComparison& all = comparison();
  EXPECT_EQ(all.slip_velocity, 1e-3);
  ASSERT_EQ(all.by_tolerance.size(), 12U);
  ASSERT_EQ(all.by_slip_velocity.size(), 12U);
  constexpr std::array names = {"bdf", "bdf, tangents", "dormand_prince"};
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(all.by_tolerance[i].name(), names.at(i / 4));
    EXPECT_EQ(all.by_slip_velocity[i].name(), names.at(i / 4));
    EXPECT_EQ(all.by_tolerance[i].slip_velocity, 1e-3);
    EXPECT_GT(all.by_tolerance[i].evaluations(), 50);
  }
  constexpr std::array slip_velocities = {0.1, 0.01, 0.001, 0.0001};
  for (std::size_t i = 0; i < 12; ++i) {
    const IntegratorTrial& trial = all.by_slip_velocity[i];
    EXPECT_DOUBLE_EQ(trial.slip_velocity, slip_velocities.at(i % 4));
    EXPECT_DOUBLE_EQ(trial.tolerance, trial.slip_velocity / 10);
  }
  // Where friction is what is stiff the explicit method pays with 1 / v_eps.
  EXPECT_GT(all.by_slip_velocity[11].evaluations(), 5 * all.by_slip_velocity[10].evaluations());
  EXPECT_GT(all.by_slip_velocity[11].evaluations(), 20 * all.by_slip_velocity[3].evaluations());
}

TEST(IntegratorComparison, LeavesOutSlipVelocitiesWhoseToleranceWouldBe1) {
  Scene scene = built_in_scene("creep");
  scene.duration = 0.01;
  set_slip_velocity(scene, 0.125);
  const IntegratorComparison all =
      compare_integrators(scene, {{"runge_kutta_merson", Method::runge_kutta_merson}}, [](const std::string&) {});
  ASSERT_EQ(all.by_slip_velocity.size(), 3U);
  EXPECT_EQ(all.by_slip_velocity[0].slip_velocity, 1.25);
}

TEST(IntegratorComparison, RefusesLawsWithoutOneSlipVelocityBeforeAnyWork) {
  const auto no_work = [](const std::string& what) { ADD_FAILURE() << what; };
  Scene scene = built_in_scene("creep");
  scene.pairings.push_back(scene.pairings[0]);
  scene.pairings[1].law.slip_velocity = 0.25;
  const auto compared = [&] { compare_integrators(scene, {{"bdf", Method::bdf}}, no_work); };
  expect_bad_input(compared, "laws of this scene have 0.001 and 0.25 m/s");
  scene.pairings[1].law.slip_velocity = 0;
  expect_bad_input(compared, "a law with friction has none; give --slip-velocity");
}

TEST(IntegratorComparison, OfBdfTangentsTakeFewerEvaluationsThanDifferencesAtEveryTolerance) {
  const IntegratorComparison& all = comparison();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(all.by_tolerance[4 + i].evaluations(), all.by_tolerance[i].evaluations());
    EXPECT_LT(all.by_tolerance[4 + i].error, 10 * all.by_tolerance[i].error);
  }
}

TEST(IntegratorComparison, ErrorsFallWithTheToleranceAndTheReferenceIsBelowThem) {
  const IntegratorComparison& all = comparison();
  EXPECT_LT(all.reference_error, 1e-6);
  EXPECT_GT(all.reference_error, 0);
  EXPECT_LT(all.by_tolerance[3].error, 0.1 * all.by_tolerance[0].error);
  EXPECT_LT(all.by_tolerance[3].error, 1e-4);
}

TEST(IntegratorComparison, TakesASceneWithFriction) {
  Scene scene = shortly_creeping();
  scene.pairings[0].law.friction = 0;
  expect_bad_input([&] { compare_integrators(scene, {}, [](const std::string&) {}); }, "no law of this scene has");
}

TEST(IntegratorComparison, TableAndPictureHaveThemAll) {
  IntegratorComparison all = comparison();
  all.by_tolerance[11].gave_up = true;
  const std::string table = markdown(comparison_table(all)), picture = comparison_picture("Creep", all);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 2 + 24 + 3);
  EXPECT_NE(table.find("| gave up |"), std::string::npos);
  EXPECT_EQ(picture.find("<?xml"), 0U);
  for (const char* words : {"Creep", ">bdf<", ">bdf, tangents<", "stroke-dasharray", ">dormand_prince<",
                            "Error over evaluations", "slip velocity"})
    EXPECT_NE(picture.find(words), std::string::npos) << words;
}

TEST(SlipVelocity, IsThatOfLawsWithFrictionAlone) {
  Scene scene = shortly_creeping();
  scene.pairings.push_back(scene.pairings[0]);
  scene.pairings[1].law.friction = 0;
  set_slip_velocity(scene, 0.02);
  EXPECT_EQ(scene.pairings[0].law.slip_velocity, 0.02);
  EXPECT_EQ(scene.pairings[1].law.slip_velocity, 1e-3);
}

}  // namespace
}  // namespace pcm::simulate
