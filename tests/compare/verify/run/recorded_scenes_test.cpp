// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The stratum trajectory: what is recorded of the scenes, who takes part, and that an engine which remembers wrongly is
// noticed.
#include "compare/verify/run/recorded_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "compare/verify/run/held_again.h"
#include "compare/verify/run/run_chunks.h"
#include "compare/verify/run/run_verdict.h"
#include "compare/verify/run/verify.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"
#include "tests/compare/small_pair.h"
#include "tests/compare/verify/routes/altering_seam.h"
#include "tests/compare/verify/run/repeats_an_answer.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

/// Changes only with the recording or with how poses are drawn along it.
constexpr std::uint64_t kGoldenHash = 0x99b471beb3175a12;

VerificationPlan plan_of(std::int64_t poses) {
  VerificationPlan plan;
  plan.poses = poses;
  plan.strata = {Stratum::trajectory};
  plan.strata_named = true;
  plan.schemes = {Scheme::barycentric, Scheme::clipped};
  plan.pairs = recorded_pairs();
  plan.build = "a test";
  return plan;
}

Tally held(const EngineSeam& seam, std::int64_t poses) {
  Verification run(plan_of(poses), seam);
  run_all(
      run, 1, [] { return false; }, [](std::int64_t) {});
  return run.total();
}

TEST(RecordedScenes, HaveFitSurfacesAndStepsThatFollowOneAnother) {
  std::set<std::string> names;
  for (const SurfacePair& pair : recorded_pairs()) {
    EXPECT_TRUE(names.insert(pair.name).second) << pair.name;
    EXPECT_NO_THROW(require_fit(pair.E));
    EXPECT_NO_THROW(require_fit(pair.F));
    EXPECT_FALSE(pair.motion.empty()) << pair.name;
    for (const RecordedStretch& steps : pair.motion) {
      EXPECT_GE(steps.size(), 2U);
      for (std::size_t i = 0; i < steps.size(); ++i) {
        double square = 0, product = 0;
        for (std::size_t k = 0; k < 4; ++k) {
          square += steps[i][k] * steps[i][k];
          product += steps[i][k] * steps[i == 0 ? 0 : i - 1][k];
        }
        EXPECT_NEAR(square, 1, 1e-8);
        EXPECT_NEAR(product, 1, 0.01) << pair.name;
      }
    }
  }
  EXPECT_GE(names.size(), 20U);
}

TEST(RecordedScenes, PosesAreTheSameBitsOnEveryMachine) {
  const PlannedPoses poses(plan_of(300));
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto mix = [&hash](double x) {
    for (int k = 0; k < 64; k += 8) hash = (hash ^ (std::bit_cast<std::uint64_t>(x) >> k & 0xff)) * 0x100000001b3;
  };
  for (const PlannedCell& cell : poses.cells())
    for (std::int64_t i = cell.first; i < cell.first + cell.poses; ++i) {
      const HeldPairing::State state = poses.asked(cell, i);
      for (const double x : state.pose.A.reshaped()) mix(x);
      for (const Eigen::Vector3d& v : {state.pose.r, state.velocity.v, state.velocity.w})
        for (const double x : v) mix(x);
      for (const MovingPose& before : state.before)
        for (const double x : before.pose.r) mix(x);
    }
  EXPECT_EQ(hash, kGoldenHash) << std::hex << "0x" << hash;
}

TEST(RecordedScenes, TakePartInTheirStratumAloneUnderTheirOwnLaw) {
  VerificationPlan plan = plan_of(400);
  plan.strata = {Stratum::generic, Stratum::nested, Stratum::trajectory};
  plan.pairs.push_back(small_pair());
  const PlannedPoses poses(plan);
  std::map<Stratum, std::int64_t> asked;
  for (const PlannedCell& cell : poses.cells()) {
    const bool is_recorded = !plan.pairs[cell.pair].motion.empty();
    EXPECT_EQ(is_recorded, cell.stratum == Stratum::trajectory);
    asked[cell.stratum] += cell.poses;
    if (!is_recorded) continue;
    const HeldPairing::State state = poses.asked(cell, cell.first);
    EXPECT_EQ(state.law.stiffness, plan.pairs[cell.pair].law.stiffness);
    EXPECT_EQ(state.scheme, cell.scheme);
    EXPECT_FALSE(state.before.empty());
  }
  EXPECT_NEAR(static_cast<double>(asked[Stratum::trajectory]), 400.0 / 3, 1);
  EXPECT_TRUE(poses.omissions().empty());
}

TEST(RecordedScenes, PairsWithoutARecordingHaveNoPartInTheStratum) {
  VerificationPlan plan = plan_of(10);
  plan.pairs = {small_pair()};
  EXPECT_THROW(PlannedPoses{plan}, BadInput);
}

TEST(RecordedScenes, HoldsAPoseAloneAsAmongTheOthers) {
  Verification run(plan_of(60));
  fast::Workspace workspace, fresh;
  const auto goes_on = [](std::int64_t) { return true; };
  const std::int64_t last = run.chunks() - 1;
  for (std::int64_t chunk = 0; chunk < last; ++chunk) run.hold_chunk(chunk, workspace, goes_on);
  const Outcomes after_others = run.hold_chunk(last, workspace, goes_on).value();
  const Outcomes alone = run.hold_chunk(last, fresh, goes_on).value();
  ASSERT_EQ(alone.cells.size(), after_others.cells.size());
  for (const auto& [cell, outcome] : alone.cells) {
    const Tally& other = after_others.cells.at(cell).tally;
    EXPECT_EQ(outcome.tally.touching, other.touching);
    EXPECT_EQ(outcome.tally.predicates, other.predicates);
    EXPECT_EQ(outcome.tally.disagreeing, 0);
    EXPECT_EQ(other.disagreeing, 0);
  }
}

TEST(RecordedScenes, ASceneThatAnswersAsAnEarlierStepIsFlagged) {
  // Scenes live one after the other, often at one address: a seam a pose.
  VerificationPlan plan = plan_of(50);
  const PlannedPoses poses(plan);
  fast::Workspace workspace;
  int asked = 0, flagged = 0;
  for (const PlannedCell& cell : poses.cells()) {
    const HeldPairing::State state = poses.asked(cell, cell.first);
    if (state.before.size() < 4) continue;
    const RepeatsAnAnswer seam;
    const PoseOutcome outcome = poses.held_pairing(cell, cell.first).hold(state, workspace, seam).front();
    ++asked;
    flagged += std::ranges::any_of(outcome.disagreements, [](const Disagreement& d) {
      return d.kind == Kind::paths && d.text.starts_with("motion: ");
    });
  }
  EXPECT_GE(asked, 20);
  EXPECT_EQ(flagged, asked);
}

/// A scene asked for its relative velocity before the last move, as far as forces show it.
class StaleVelocity final : public EngineSeam {
 public:
  const fast::Contact& evaluate_in(fast::Scene& scene, fast::Workspace& workspace) const override {
    const Velocity now = scene.relative_velocity(0);
    const fast::Contact& answer = EngineSeam::evaluate_in(scene, workspace);
    stale_ = fast::evaluate(scene.pairing(0), scene.relative_pose(0), last_, {}, other_);
    last_ = now;
    stale_.work = answer.work;
    return stale_;
  }

 private:
  mutable Velocity last_;
  mutable fast::Contact stale_;
  mutable fast::Workspace other_;
};

TEST(RecordedScenes, ASceneWithTheVelocityBeforeIsFlagged) {
  EXPECT_EQ(held(EngineSeam::none(), 50).disagreeing, 0);
  EXPECT_GE(held(StaleVelocity(), 50).disagreeing, 45);
}

TEST(RecordedScenes, ACaseOfThemReplaysWithTheWayThere) {
  const TemporaryFolder folder;
  const PlannedPoses poses(plan_of(50));
  const PlannedCell& cell = poses.cells().front();
  const HeldPairing::State state = poses.asked(cell, cell.first);
  write_text_file(folder.path("case.json"), format_case(poses.as_case(cell, cell.first), {}, {}));
  const Case posed = read_case(folder.path("case.json"));
  ASSERT_GT(state.before.size(), 0U);
  ASSERT_EQ(posed.before.size(), state.before.size());
  for (std::size_t i = 0; i < state.before.size(); ++i) {
    EXPECT_EQ(posed.before[i].pose.A, state.before[i].pose.A);
    EXPECT_EQ(posed.before[i].pose.r, state.before[i].pose.r);
    EXPECT_EQ(posed.before[i].velocity.v, state.before[i].velocity.v);
    EXPECT_EQ(posed.before[i].velocity.w, state.before[i].velocity.w);
  }
  EXPECT_TRUE(held_again(posed).disagreements.empty());
  EXPECT_FALSE(held_again(posed, StaleVelocity()).disagreements.empty()) << "without the way nothing is stale";
}

}  // namespace
}  // namespace pcm::compare
