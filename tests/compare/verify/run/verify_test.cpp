// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the comparison: right answers pass, tables repeat, runs resume, and what gets no pose is said.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "compare/verify/run/run_chunks.h"
#include "compare/verify/run/run_identity.h"
#include "compare/verify/run/run_verdict.h"
#include "compare/verify/run/verify.h"
#include "compare/verify/tables/summary.h"
#include "compare/verify/tables/verification_table.h"
#include "meshes/generate/degenerate/lattice_tetrahedra.h"
#include "pcm/bad_input.h"
#include "tests/compare/small_pair.h"
#include "tests/compare/verify/routes/altering_seam.h"

namespace pcm::compare {
namespace {

const auto kNever = [] { return false; };
const auto kSilent = [](std::int64_t) {};

VerificationPlan small_plan(std::int64_t poses) {
  VerificationPlan plan;
  plan.poses = poses;
  plan.pairs = {small_pair()};
  return plan;
}

void run_all(Verification& run, int jobs) {
  run_all(run, jobs, kNever, kSilent);
}

/// All that a run has found, as a kept one has it.
Outcomes outcomes_of(const Verification& run) {
  Outcomes outcomes;
  for (std::size_t c = 0; c < run.cells().size(); ++c)
    outcomes.cells[c] = CellOutcome::from_json(nlohmann::ordered_json::parse(run.cells()[c].to_json().dump()));
  outcomes.findings = run.findings();
  return outcomes;
}

TEST(Verification, SmallPairAgreesInEveryStratum) {
  Verification run(small_plan(600));
  run_all(run, 2);
  const Tally total = run.total();
  EXPECT_EQ(total.poses, 600);
  EXPECT_EQ(total.disagreeing, 0);
  for (const Finding& finding : run.findings())
    for (const Disagreement& d : finding.disagreements)
      ADD_FAILURE() << run.poses().pose_name(run.cells()[finding.cell], finding.pose) << ": " << name(d.kind) << ": "
                    << d.text;
  for (const Cell& cell : run.cells()) {
    const double touching = static_cast<double>(cell.tally.touching) / static_cast<double>(cell.poses);
    if (cell.stratum == Stratum::separated || cell.stratum == Stratum::nested) {
      EXPECT_EQ(cell.tally.touching, 0) << name(cell.stratum);
    } else {
      EXPECT_GE(touching, 0.5) << name(cell.stratum);
    }
    if (cell.stratum == Stratum::nested) {
      EXPECT_EQ(cell.tally.nested, cell.poses);
    }
  }
}

TEST(Verification, ErrorsAboveTheMeasureAreNamedWithTheirPercentile) {
  VerificationPlan plan = small_plan(240);
  plan.strata = {Stratum::generic};
  Verification right(plan);
  run_all(right, 2);
  EXPECT_FALSE(missed_measure(right).has_value());

  const AlteringSeam deeper([](fast::Contact& contact) {
    contact.max_penetration *= 1 + 1e-10;
    return true;
  });
  Verification wrong(plan, deeper);
  run_all(wrong, 1);
  const std::optional<MissedMeasure> missed = missed_measure(wrong);
  ASSERT_TRUE(missed.has_value());
  EXPECT_EQ(missed->what, "penetration");
  EXPECT_NE(verdict_line(wrong).find("at the 99th percentile"), std::string::npos) << verdict_line(wrong);

  const AlteringSeam wider([](fast::Contact& contact) {
    contact.volume *= 1 + 1e-10;
    return true;
  });
  Verification too_wide(plan, wider);
  run_all(too_wide, 1);
  EXPECT_NE(verdict_line(too_wide).find("volume error"), std::string::npos) << verdict_line(too_wide);
  EXPECT_NE(verdict_line(too_wide).find("at the 99.9th percentile"), std::string::npos);
}

TEST(Verification, PosesOfAPairWithVariantsTakeThemInTurn) {
  VerificationPlan plan;
  plan.poses = 60;
  plan.strata = {Stratum::degenerate};
  SurfacePair& pair = plan.pairs.emplace_back(small_pair());
  for (const std::uint64_t number : {0, 2}) pair.variants.push_back(degenerate::lattice_tetrahedra(number));
  Verification run(plan);
  const Cell& cell = run.cells().front();
  std::vector<std::vector<Eigen::Vector3d>> expected = {pair.E.vertices, pair.variants[0][0].vertices,
                                                        pair.variants[1][0].vertices};
  for (std::int64_t pose = 0; pose < 6; ++pose) {
    EXPECT_EQ(run.poses().held_pairing(cell, pose).features().E.mesh.vertices,
              expected[static_cast<std::size_t>(pose % 3)])
        << pose;
    EXPECT_EQ(run.as_case({0, pose, {}}).E.vertices, expected[static_cast<std::size_t>(pose % 3)]) << pose;
  }
  run_all(run, 2);
  EXPECT_EQ(run.total().disagreeing, 0);
  EXPECT_GT(run.total().touching, 30);
}

TEST(Verification, TablesDoNotDependOnTheNumberOfThreads) {
  Verification one(small_plan(240)), four(small_plan(240));
  run_all(one, 1);
  run_all(four, 4);
  EXPECT_EQ(verification_markdown(one), verification_markdown(four));
  EXPECT_EQ(verification_csv(one), verification_csv(four));
  EXPECT_EQ(verification_json(one), verification_json(four));
}

TEST(Verification, AllModesTogetherAnswerAsThreeRunsBitForBit) {
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    VerificationPlan plan = small_plan(60);
    plan.schemes = {scheme};
    plan.modes = {Mode::E, Mode::F, Mode::both};
    Verification together(plan);
    run_all(together, 2);
    EXPECT_EQ(together.poses_done(), 60);
    EXPECT_EQ(together.total().poses, 180);
    const auto answers = [](const Tally& tally) {
      nlohmann::ordered_json json = tally.to_json();
      json.erase("seconds");
      return json;
    };
    for (std::size_t m = 0; m < 3; ++m) {
      plan.modes = {std::vector{Mode::E, Mode::F, Mode::both}[m]};
      Verification alone(plan);
      run_all(alone, 2);
      EXPECT_EQ(answers(together.by_mode()[m].tally), answers(alone.total()));
      ASSERT_EQ(together.cells().size(), 3 * alone.cells().size());
      for (std::size_t c = 0; c < alone.cells().size(); ++c) {
        EXPECT_EQ(together.cells()[3 * c + m].mode, plan.modes.front());
        EXPECT_EQ(answers(together.cells()[3 * c + m].tally), answers(alone.cells()[c].tally));
      }
    }
    Verification continued(together.plan());
    continued.add(outcomes_of(together));
    EXPECT_EQ(verification_csv(continued), verification_csv(together));
    EXPECT_EQ(verification_markdown(continued), verification_markdown(together));
    EXPECT_NE(verdict_line(together).find("60 poses in 3 modes"), std::string::npos);
  }
}

TEST(Verification, ChunksInAnyOrderAndPartsMakeTheWholeRun) {
  VerificationPlan plan = small_plan(900);
  plan.modes = {Mode::E, Mode::both};
  Verification whole(plan), first(plan), second(plan);
  run_all(whole, 2);
  ASSERT_GT(whole.chunks(), 100);
  fast::Workspace workspace;
  const auto goes_on = [](std::int64_t) { return true; };
  for (std::int64_t chunk = whole.chunks() - 1; chunk >= 0; --chunk)
    (chunk % 3 == 0 ? first : second).add(*whole.hold_chunk(chunk, workspace, goes_on));
  EXPECT_LT(first.poses_done(), 400);
  EXPECT_EQ(first.poses_done() + second.poses_done(), 900);
  EXPECT_FALSE(first.finished());
  first.add(outcomes_of(second));
  EXPECT_TRUE(first.finished());
  EXPECT_EQ(verification_csv(first), verification_csv(whole));
  EXPECT_EQ(verification_markdown(first), verification_markdown(whole));
  EXPECT_EQ(without_scene_line(first), without_scene_line(whole));
}

/// A plan of both schemes, two pairs and all strata.
VerificationPlan plan_of_both_schemes(std::int64_t poses) {
  VerificationPlan plan = small_plan(poses);
  plan.schemes = {Scheme::barycentric, Scheme::clipped};
  SurfacePair& second = plan.pairs.emplace_back(small_pair());
  second.name = "the other pair";
  std::swap(second.E, second.F);
  return plan;
}

TEST(Verification, ChunksAreAlikeAndHaveEachPoseOnce) {
  const Verification run(plan_of_both_schemes(500));
  fast::Workspace workspace;
  std::int64_t all = 0;
  std::map<std::size_t, std::int64_t> of_cell;
  for (std::int64_t chunk = 0; chunk < run.chunks(); ++chunk) {
    std::int64_t poses = 0;
    const std::optional<Outcomes> outcomes = run.hold_chunk(chunk, workspace, [&](std::int64_t more) {
      poses += more;
      return true;
    });
    ASSERT_TRUE(outcomes.has_value());
    EXPECT_GE(poses, 7) << chunk;
    EXPECT_LE(poses, 8) << chunk;
    all += poses;
    for (const auto& [cell, outcome] : outcomes->cells) of_cell[cell] += outcome.tally.poses;
  }
  EXPECT_EQ(all, 500);
  for (std::size_t c = 0; c < run.cells().size(); ++c) EXPECT_EQ(of_cell[c], run.cells()[c].poses) << c;
}

TEST(Verification, InterruptedKeepsTheChunksThatAreDone) {
  Verification run(small_plan(240));
  int asked = 0;
  run_all(
      run, 1, [&] { return ++asked > 100; }, kSilent);
  EXPECT_GT(run.poses_done(), 0);
  EXPECT_LT(run.poses_done(), 100);
  EXPECT_TRUE(verdict_line(run).starts_with("unfinished: " + std::to_string(run.poses_done()) + " poses"))
      << verdict_line(run);
  EXPECT_NE(verdict_line(run).find("interrupted"), std::string::npos);
  EXPECT_FALSE(is_verified(run));
}

TEST(Verification, WhatIsThrownInAThreadEndsItAndIsThrown) {
  Verification run(small_plan(240));
  EXPECT_THROW(run_all(
                   run, 2, []() -> bool { throw BadInput("stop"); }, kSilent),
               BadInput);
}

TEST(Verification, NoPoseOfAPairAndStratumIsAskedTwice) {
  const Verification run(plan_of_both_schemes(1800));
  std::map<std::pair<std::size_t, Stratum>, std::set<std::int64_t>> numbers;
  std::set<std::vector<double>> states;
  std::size_t poses = 0, generic = 0;
  for (const Cell& cell : run.cells())
    for (std::int64_t pose = cell.first; pose < cell.first + cell.poses; ++pose) {
      ++poses;
      EXPECT_TRUE(numbers[std::pair(cell.pair, cell.stratum)].insert(pose).second) << run.poses().pose_name(cell, pose);
      if (cell.stratum != Stratum::generic) continue;  // of the others some may be in one place by chance
      ++generic;
      const HeldPairing::State state = run.poses().asked(cell, pose);
      states.insert({state.pose.r.x(), state.pose.r.y(), state.pose.r.z(), state.law.stiffness, state.law.damping,
                     state.law.friction});
    }
  EXPECT_EQ(poses, 1800U);
  EXPECT_EQ(states.size(), generic);
  for (const auto& [key, found] : numbers)
    EXPECT_EQ(*found.rbegin() + 1, std::ssize(found)) << "numbers from 0 on without a gap";
  EXPECT_EQ(run.cells().front().first, 0);
}

/// Poses of a stratum in a scheme that fall to pairs made to hurt, and to others.
std::pair<std::int64_t, std::int64_t> hurting_and_others(const PlannedPoses& planned, Stratum stratum, Scheme scheme) {
  std::pair<std::int64_t, std::int64_t> sum{0, 0};
  for (const PlannedCell& cell : planned.cells()) {
    if (cell.stratum != stratum || cell.scheme != scheme) continue;
    (planned.plan().pairs[cell.pair].made_to_hurt ? sum.first : sum.second) += cell.poses;
  }
  return sum;
}

TEST(PlannedPoses, HalfOfGenericPosesAtLeastFallToPairsThatAreNotMadeToHurt) {
  VerificationPlan plan = plan_of_both_schemes(1800);
  plan.strata = {Stratum::generic, Stratum::grazing};
  plan.pairs = {small_pair(), small_pair(), small_pair(), small_pair(), small_pair()};
  for (std::size_t k = 0; k < plan.pairs.size(); ++k) {
    plan.pairs[k].name = "pair " + std::to_string(k);
    plan.pairs[k].greatest_share = 100;
    plan.pairs[k].made_to_hurt = k > 0;
  }
  using Counts = std::pair<std::int64_t, std::int64_t>;
  const PlannedPoses mostly_hurting(plan);
  EXPECT_EQ(hurting_and_others(mostly_hurting, Stratum::generic, Scheme::clipped), Counts(150, 150));
  EXPECT_EQ(hurting_and_others(mostly_hurting, Stratum::generic, Scheme::barycentric), Counts(300, 300));
  EXPECT_EQ(hurting_and_others(mostly_hurting, Stratum::grazing, Scheme::clipped), Counts(240, 60));

  plan.poses = 102;  // 51 a stratum: an odd one goes to the others
  EXPECT_EQ(hurting_and_others(PlannedPoses(plan), Stratum::generic, Scheme::clipped), Counts(8, 9));
  EXPECT_EQ(hurting_and_others(PlannedPoses(plan), Stratum::generic, Scheme::barycentric), Counts(17, 17));
  plan.poses = 1800;

  for (std::size_t k = 1; k < 4; ++k) plan.pairs[k].made_to_hurt = false;
  EXPECT_EQ(hurting_and_others(PlannedPoses(plan), Stratum::generic, Scheme::clipped), Counts(60, 240));

  for (SurfacePair& pair : plan.pairs) pair.made_to_hurt = true;
  EXPECT_EQ(hurting_and_others(PlannedPoses(plan), Stratum::generic, Scheme::clipped), Counts(300, 0));
}

TEST(PlannedPoses, UnderAGivenLawAskTheSamePosesAndVelocitiesUnderItAlone) {
  const VerificationPlan drawn = plan_of_both_schemes(120);
  VerificationPlan given = drawn;
  given.law = ContactLaw{};
  given.law->stiffness = 0x1p17;
  given.law->friction = 0.25;
  const PlannedPoses by_draw(drawn), by_law(given);
  int with_another_law = 0;
  for (const PlannedCell& cell : by_law.cells())
    for (std::int64_t pose = cell.first; pose < cell.first + cell.poses; ++pose) {
      const HeldPairing::State asked = by_law.asked(cell, pose), usual = by_draw.asked(cell, pose);
      EXPECT_EQ(asked.pose.A, usual.pose.A);
      EXPECT_EQ(asked.pose.r, usual.pose.r);
      EXPECT_EQ(asked.velocity.v, usual.velocity.v);
      EXPECT_EQ(asked.velocity.w, usual.velocity.w);
      EXPECT_EQ(asked.scheme, usual.scheme);
      EXPECT_EQ(asked.law.stiffness, 0x1p17);
      EXPECT_EQ(asked.law.friction, 0.25);
      EXPECT_FALSE(asked.law.layers.has_value());
      with_another_law += usual.law.stiffness != 0x1p17 ? 1 : 0;
    }
  EXPECT_EQ(with_another_law, 120);
  EXPECT_NE(identity_of(given), identity_of(drawn));
  EXPECT_FALSE(same_arguments(given, identity_of(drawn)));
}

TEST(Verification, PosesOfOneSchemeAloneAreNumberedFromZero) {
  VerificationPlan plan = plan_of_both_schemes(60);
  plan.schemes = {Scheme::clipped};
  const Verification run(plan);
  for (const Cell& cell : run.cells()) EXPECT_EQ(cell.first, 0);
}

TEST(Verification, FindingsOfTheClippedSchemeAreThePosesThatWereAsked) {
  VerificationPlan plan = plan_of_both_schemes(120);
  plan.strata = {Stratum::generic};
  const Verification run(plan);
  const auto clipped = std::find_if(run.cells().begin(), run.cells().end(),
                                    [](const Cell& cell) { return cell.scheme == Scheme::clipped; });
  ASSERT_NE(clipped, run.cells().end());
  ASSERT_GT(clipped->first, 0);
  const Case posed = run.as_case({static_cast<std::size_t>(clipped - run.cells().begin()), clipped->first, {}});
  EXPECT_EQ(posed.scheme, Scheme::clipped);
  EXPECT_EQ(posed.pose.r, run.poses().draw(*clipped, clipped->first).pose.r);
  EXPECT_NE(posed.origin.find(std::to_string(clipped->first) + "/both/clipped"), std::string::npos) << posed.origin;
}

bool any_says(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

TEST(Verification, WhatIsNamedMustGetAPose) {
  // A pose a stratum: the second pair gets all of them.
  const VerificationPlan plan = plan_of_both_schemes(std::ssize(kStrata));
  const auto expect_refused = [](const VerificationPlan& named, const std::string& what) {
    try {
      const Verification run(named);
      ADD_FAILURE() << what << " got no pose, and nobody said so";
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  VerificationPlan pairs = plan, schemes = plan, strata = plan, nested = plan;
  pairs.pairs_named = true;
  expect_refused(pairs, "pair " + small_pair().name);
  schemes.schemes_named = true;
  expect_refused(schemes, "clipped scheme");
  strata.strata_named = true;
  strata.poses = std::ssize(kStrata) - 1;
  expect_refused(strata, "stratum generic");
  nested.strata_named = true;
  for (SurfacePair& pair : nested.pairs)
    for (TriangleMesh* mesh : {&pair.E, &pair.F}) mesh->faces.pop_back();  // open, so that nothing is inside
  expect_refused(nested, "stratum nested gets no pose: it is not to be had");
}

TEST(Verification, WhatGetsNoPoseIsSaidInTablesAndVerdict) {
  Verification run(plan_of_both_schemes(std::ssize(kStrata) - 1));
  run_all(run, 1);
  for (const std::string& words : {std::string("stratum generic"), std::string("clipped scheme"),
                                   "1 of 2 pairs get no pose (" + small_pair().name}) {
    EXPECT_TRUE(any_says(run.poses().omissions(), words)) << words;
    EXPECT_NE(verification_summary(run).find(words), std::string::npos) << words;
    EXPECT_NE(verification_markdown(run).find(words), std::string::npos) << words;
  }
  EXPECT_NE(verdict_line(run).find("(no pose: generic; clipped scheme; 1 of 2 pairs)"), std::string::npos)
      << verdict_line(run);
  const Verification enough(plan_of_both_schemes(120));
  EXPECT_EQ(enough.poses().without_poses(), "");
  EXPECT_TRUE(enough.poses().omissions().empty()) << enough.poses().omissions().front();
}

/// Breaks down, by no BadInput, when a law is drawn at some poses.
class BreakingSeam final : public EngineSeam {
 public:
  const fast::Contact& evaluate_for_draw(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                         const Wanted& wanted, fast::Workspace& workspace) const override {
    if (pose.r.x() > 0) throw std::logic_error("out of order");
    return EngineSeam::evaluate_for_draw(pairing, pose, velocity, wanted, workspace);
  }
};

TEST(Verification, EngineThatBreaksDownWhileALawIsDrawnFailsThatPoseAndHasACase) {
  VerificationPlan plan = small_plan(60);
  plan.strata = {Stratum::generic};
  plan.modes = {Mode::E, Mode::both};
  const BreakingSeam seam;
  Verification run(plan, seam);
  run_all(run, 2);
  EXPECT_EQ(run.poses_done(), 60);
  const Tally total = run.total();
  EXPECT_GT(total.disagreeing, 0);
  EXPECT_LT(total.disagreeing, total.poses);
  EXPECT_EQ(total.by_kind[static_cast<std::size_t>(Kind::failure)], total.disagreeing);
  ASSERT_FALSE(run.findings().empty());
  const Finding& finding = run.findings().front();
  EXPECT_NE(finding.disagreements.front().text.find("out of order"), std::string::npos);
  const Case posed = run.as_case(finding);
  EXPECT_EQ(posed.mode, Mode::both);
  EXPECT_GT(posed.pose.r.x(), 0);
  EXPECT_TRUE(verdict_line(run).starts_with("NOT verified")) << verdict_line(run);
}

TEST(Verification, PosesThatNoSceneIsAskedAboutAreCountedAndKept) {
  VerificationPlan plan = small_plan(600);
  plan.strata = {Stratum::near_degenerate};
  plan.modes = {Mode::E, Mode::F};
  Verification run(plan);
  run_all(run, 2);
  std::int64_t skipped = 0;
  const Cell& cell = run.cells().front();
  for (std::int64_t pose = 0; pose < cell.poses; ++pose)
    skipped += !is_pose_for_scenes(run.poses().asked(cell, pose).pose);
  ASSERT_GT(skipped, 0);
  const std::string words = "no scene was asked about " + std::to_string(skipped) + " of 600 poses";
  EXPECT_NE(verification_summary(run).find(words), std::string::npos) << without_scene_line(run);
  EXPECT_NE(verification_markdown(run).find(words), std::string::npos);
  EXPECT_EQ(verification_json(run)["without_scene"]["near-degenerate"], skipped);
  Verification continued(plan);
  continued.add(outcomes_of(run));
  EXPECT_EQ(without_scene_line(continued), without_scene_line(run));
}

}  // namespace
}  // namespace pcm::compare
