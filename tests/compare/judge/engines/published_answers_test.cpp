// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The published algorithms as anybody's engines: `pcm answer` in a conversation, judged fact by fact, must be wrong as
// often, and in the same, as `pcm verify --engine` finds them.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "compare/judge/engines/asked_engine.h"
#include "compare/judge/judgement/judge.h"
#include "compare/judge/poses/poses_folder.h"
#include "compare/judge/poses/write_poses.h"
#include "compare/wrong_answers/engine_comparison.h"
#include "tests/compare/small_pair.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

constexpr std::size_t index_of(Wrong wrong) {
  return static_cast<std::size_t>(wrong);
}

VerificationPlan small_plan(std::int64_t poses) {
  VerificationPlan plan;
  plan.poses = poses;
  plan.pairs = {small_pair()};
  return plan;
}

/// The measure of `pcm verify --engine`: 1e-9 of what errors are measured against.
Tolerances measure_of_verify() {
  Tolerances tolerances;
  tolerances.add("--tolerance", {"force=1e-9", "torque=1e-9"}, &Tolerance::relative);
  return tolerances;
}

/// What that counts of one pose, from what the judge says: faces and forces are excused where the published algorithms
/// have no rule (wrong_answers.h). How a polygon runs is no fact of an answer, and neither are its gaps.
ComparisonTally::OfEngine counted(const PoseVerdict& verdict, const GivenAnswer& answer,
                                  const reference::Answer& truth) {
  const auto is_wrong = [&](Fact fact) {
    return std::any_of(verdict.facts.begin(), verdict.facts.end(), [fact](const FactVerdict& judged) {
      return judged.fact == fact && judged.verdict == Verdict::wrong;
    });
  };
  const bool inside_is_told = !(truth.nested || truth.ambiguous), rule = !without_rule(truth);
  const bool force = is_wrong(Fact::force) || is_wrong(Fact::torque);
  ComparisonTally::OfEngine tally;
  tally.by[index_of(Wrong::touching)] = is_wrong(Fact::touching);
  tally.by[index_of(Wrong::open_chains)] = answer.polygons != answer.closed_polygons;
  tally.by[index_of(Wrong::active_faces)] =
      is_wrong(Fact::intersected_faces) || (inside_is_told && is_wrong(Fact::inner_faces));
  tally.by[index_of(Wrong::elements)] = rule && is_wrong(Fact::elements);
  tally.by[index_of(Wrong::force)] = rule && force;
  tally.differs_without_rule = !rule && force;
  return tally;
}

using Tallies = std::map<std::string, ComparisonTally::OfEngine>;  ///< by stratum

Tallies through_judge(Engine engine, std::int64_t poses) {
  const TemporaryFolder scratch;
  write_poses(
      scratch.path("poses"), PlannedPoses(small_plan(poses)), PosedLaw::of_pair, Notation::decimal, 2,
      [] { return false; }, [](std::int64_t) {});
  const PosedQuestions posed = read_poses_folder(scratch.path("poses"));
  const Tolerances tolerances = measure_of_verify();
  const Judge judge(posed, tolerances, 0);
  AskedEngine asked(std::string("'" PCM_PROGRAM "' answer --engine ") + std::string(name(engine)), posed,
                    scratch.path("poses"), Conversation::Seconds(60));
  Tallies tallies;
  for (std::size_t k = 0; k < posed.questions.size(); ++k) {
    const PosedQuestion& question = posed.questions[k];
    const Reply reply = asked.ask(k).value();
    EXPECT_FALSE(reply.breakdown) << question.id << ": " << reply.failure;
    const ComparisonTally::OfEngine one =
        counted(judge.judge(question, reply.answer), reply.answer, judge.truth(question));
    ComparisonTally::OfEngine& tally = tallies[question.stratum];
    for (std::size_t wrong = 0; wrong < kWrongs; ++wrong) tally.by[wrong] += one.by[wrong];
    tally.differs_without_rule += one.differs_without_rule;
  }
  return tallies;
}

void expect_counts_of_verify(std::int64_t poses) {
  for (const Engine engine : {Engine::published_2003, Engine::published_2023}) {
    const EngineComparison verified = compare_engines(
        small_plan(poses), {engine}, 2, [] { return false; }, [](std::int64_t) {});
    const Tallies judged = through_judge(engine, poses);
    ASSERT_EQ(judged.size(), verified.strata.size());
    std::int64_t wrong = 0;
    for (const auto& [stratum, tally] : verified.strata) {
      const ComparisonTally::OfEngine& of_verify = tally.of(engine);
      const ComparisonTally::OfEngine& of_judge = judged.at(std::string(name(stratum)));
      const std::string where = std::string(name(engine)) + ", " + std::string(name(stratum)) + ": ";
      for (const Wrong what :
           {Wrong::touching, Wrong::open_chains, Wrong::active_faces, Wrong::elements, Wrong::force}) {
        EXPECT_EQ(of_judge.by[index_of(what)], of_verify.by[index_of(what)]) << where << name(what);
        wrong += of_verify.by[index_of(what)];
      }
      EXPECT_EQ(of_judge.differs_without_rule, of_verify.differs_without_rule) << where;
    }
    EXPECT_GT(wrong, 0) << name(engine);
  }
}

TEST(PublishedAnswers, AreWrongAsOftenAsVerifyFindsThem) {
  expect_counts_of_verify(360);
}

}  // namespace
}  // namespace pcm::compare
