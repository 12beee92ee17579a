// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What counts as a wrong answer, and how several engines are held against the oracle.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <limits>

#include "compare/wrong_answers/engine_comparison.h"
#include "pcm/bad_input.h"
#include "tests/compare/small_pair.h"

namespace pcm::compare::engine_comparison_test {
namespace {

VerificationPlan small_plan(std::int64_t poses) {
  VerificationPlan plan;
  plan.poses = poses;
  plan.pairs = {small_pair()};
  return plan;
}

EngineComparison small_comparison(std::int64_t poses, int jobs) {
  return compare_engines(
      small_plan(poses), {kEngines.begin(), kEngines.end()}, jobs, [] { return false; }, [](std::int64_t) {});
}

/// The engine's answer to a pose with some elements, altered: each alteration is noticed as what it is, by an engine
/// that could know.
TEST(WrongAnswers, AlteredAnswersAreToldApart) {
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, pair.law, Mode::both);
  Pose pose;
  pose.A = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.r = {0.3, 0.2, 0.6};
  fast::Workspace workspace;
  const fast::Contact right = fast::evaluate(held.engine(), pose, {}, {}, workspace);
  const reference::Answer truth = held.oracle().answer(reference::Problem::rounded, pose);
  const Question question = held.question(pose, {});
  ASSERT_GT(right.elements.size(), 3u);
  EXPECT_FALSE(without_rule(truth));
  for (const Engine engine : kEngines) EXPECT_TRUE(wrongs(question, engine, &right, truth).none());

  const auto expect = [&](Wrong wrong, const std::function<void(fast::Contact&)>& alter) {
    fast::Contact altered = right;
    alter(altered);
    for (const Engine engine : kEngines)
      EXPECT_EQ(wrongs(question, engine, &altered, truth)[static_cast<std::size_t>(wrong)], answers(engine, wrong))
          << name(engine) << ": " << name(wrong);
  };
  expect(Wrong::touching, [](fast::Contact& c) { c.touching = false; });
  expect(Wrong::open_chains, [](fast::Contact& c) { c.polygons.front().closed = false; });
  expect(Wrong::polygons, [](fast::Contact& c) { c.polygons.pop_back(); });
  expect(Wrong::polygons, [](fast::Contact& c) { ++c.crossings.back().face; });
  expect(Wrong::active_faces, [](fast::Contact& c) { c.F.inner.push_back(1000); });
  expect(Wrong::active_faces, [](fast::Contact& c) { c.E.intersected.pop_back(); });
  expect(Wrong::elements, [](fast::Contact& c) { c.elements.pop_back(); });
  expect(Wrong::elements, [](fast::Contact& c) { ++c.elements.back().slave_face; });
  expect(Wrong::force, [&](fast::Contact& c) { c.force_Me.x() += 2e-9 * truth.force_scale; });
  expect(Wrong::force, [&](fast::Contact& c) { c.torque_Me.x() += 2e-9 * truth.torque_scale; });
  expect(Wrong::force, [](fast::Contact& c) { c.force_Me.x() = std::numeric_limits<double>::quiet_NaN(); });
  fast::Contact near = right;
  near.force_Me.x() += 0.5e-9 * truth.force_scale;
  EXPECT_TRUE(wrongs(question, Engine::fast, &near, truth).none());
  for (const Engine engine : kEngines)
    EXPECT_TRUE(wrongs(question, engine, nullptr, truth)[static_cast<std::size_t>(Wrong::failure)]);
}

TEST(EngineComparison, TheEngineIsNeverWrongThePaperIsWhereFeaturesCoincide) {
  const EngineComparison result = small_comparison(60 * std::ssize(kStrata), 1);
  ASSERT_TRUE(result.finished);
  EXPECT_EQ(result.all.poses, 60 * std::ssize(kStrata));
  EXPECT_EQ(result.all.of(Engine::fast).wrong, 0);
  for (const auto& [stratum, tally] : result.strata) {
    EXPECT_EQ(tally.poses, 60);
    if (stratum == Stratum::generic) {
      EXPECT_GT(tally.shallow, 30);
      for (const Engine engine : kEngines) EXPECT_EQ(tally.of(engine).shallow_force_wrong, 0) << name(engine);
    }
    if (stratum == Stratum::degenerate) {
      EXPECT_GT(tally.of(Engine::published_2003).by[static_cast<std::size_t>(Wrong::polygons)], 20);
      EXPECT_GT(tally.of(Engine::published_2003).by[static_cast<std::size_t>(Wrong::open_chains)], 10);
      EXPECT_EQ(tally.of(Engine::published_2023).by[static_cast<std::size_t>(Wrong::polygons)], 0);
    }
  }
  EXPECT_TRUE(result.anything_wrong());
}

TEST(EngineComparison, TheTableDoesNotDependOnTheNumberOfThreads) {
  const EngineComparison one = small_comparison(120, 1), three = small_comparison(120, 3);
  EXPECT_EQ(one.all.without_rule, three.all.without_rule);
  for (const Engine engine : kEngines) {
    EXPECT_EQ(one.all.of(engine).wrong, three.all.of(engine).wrong);
    EXPECT_EQ(one.all.of(engine).by, three.all.of(engine).by);
  }
}

TEST(EngineComparison, StoppedItKeepsWhatItHas) {
  const EngineComparison result = compare_engines(
      small_plan(60), {Engine::published_2003}, 1, [] { return true; }, [](std::int64_t) {});
  EXPECT_FALSE(result.finished);
  EXPECT_EQ(result.all.poses, 0);
}

TEST(EngineComparison, RefusesTheClippedScheme) {
  VerificationPlan plan = small_plan(6);
  plan.schemes = {Scheme::clipped};
  EXPECT_THROW(compare_engines(
                   plan, {Engine::published_2003}, 1, [] { return false; }, [](std::int64_t) {}),
               BadInput);
}

}  // namespace
}  // namespace pcm::compare::engine_comparison_test
