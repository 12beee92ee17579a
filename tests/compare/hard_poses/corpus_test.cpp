// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The hardest states known, replayed: the engine within its bound of the answers that are stored, by all routes, and
// every state as hard as when it was found.
#include "tests/compare/hard_poses/corpus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "compare/hard_poses/hardness.h"
#include "compare/io/names.h"
#include "compare/verify/run/held_again.h"
#include "meshes/files/text_file.h"

namespace pcm::compare::hard_poses_test {
namespace {

class HardPosesCorpus : public testing::Test {
 protected:
  const std::string text_ = read_text_file(PCM_SOURCE_DIR "/tests/compare/hard_poses/corpus.json");
  const std::vector<CorpusState> states_ = corpus_from(text_);
  const CorpusPairs pairs_;
  fast::Workspace workspace_;
};

std::string name_of(const CorpusState& hard, std::size_t number) {
  return "line " + std::to_string(number + 2) + ", " + hard.pair + ", " + std::string(name(hard.state.scheme)) + ", " +
         std::string(name(hard.goal));
}

TEST_F(HardPosesCorpus, HoldsStatesOfAllGoalsSchemesAndModesUnderManyLawsAndOnMovedSurfaces) {
  std::set<std::pair<Goal, Scheme>> kinds;
  std::set<Mode> modes;
  std::set<DampingMode> damping_modes;
  int moving = 0, moved = 0, with_friction = 0, layered = 0;
  for (const CorpusState& hard : states_) {
    kinds.insert({hard.goal, hard.state.scheme});
    modes.insert(hard.mode);
    damping_modes.insert(hard.state.law.damping_mode);
    moving += !hard.state.velocity.v.isZero(0);
    moved += !hard.moved.empty();
    with_friction += hard.state.law.friction > 0;
    layered += hard.state.law.layers.has_value();
  }
  EXPECT_EQ(kinds.size(), 10U);
  EXPECT_EQ(modes.size(), 3U);
  EXPECT_EQ(damping_modes.size(), 3U);
  for (const int some : {moving, moved, with_friction, layered}) EXPECT_GE(some, 20);
  EXPECT_GE(states_.size(), 180U);
  EXPECT_EQ(corpus_text(states_), text_);
}

TEST_F(HardPosesCorpus, EngineIsWithinItsBoundOfTheStoredTruth) {
  Wanted wanted;
  wanted.bound = true;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const CorpusState& stored = states_[i];
    SCOPED_TRACE(name_of(stored, i));
    const HardState hard = pairs_.hard(stored);
    const fast::Pairing engine = hard.held->engine_under(stored.state.law, stored.mode, stored.state.scheme);
    const fast::Contact& subj = fast::evaluate(engine, stored.state.pose, stored.state.velocity, wanted, workspace_);
    for (int j = 0; j < 3; ++j) {
      EXPECT_LE(std::abs(subj.force_Me[j] - stored.true_force_Me[j]), subj.bound->force_Me[j]);
      EXPECT_LE(std::abs(subj.torque_Me[j] - stored.true_torque_Me[j]), subj.bound->torque_Me[j]);
    }
  }
}

TEST_F(HardPosesCorpus, OracleAnswersAsStoredAndEveryRouteAgrees) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const CorpusState& stored = states_[i];
    SCOPED_TRACE(name_of(stored, i));
    const HardState hard = pairs_.hard(stored);
    reference::Inquiry inquiry(hard.held->oracle(), stored.state.pose, stored.state.velocity, {}, stored.state.law,
                               stored.state.scheme);
    const reference::Answer truth = inquiry.answer(reference::Problem::exact, stored.mode);
    EXPECT_EQ(truth.force_Me, stored.true_force_Me);
    EXPECT_EQ(truth.torque_Me, stored.true_torque_Me);
    for (const Disagreement& d : held_again(as_case(hard, "")).disagreements) ADD_FAILURE() << d.text;
  }
}

/// States at which a search found engine and oracle apart, by a fault that is mended (found.json):
/// - lines 2 and 3 (seed 5, climbs 146 and 1196): a face of the slave lies in the plane of one of the master's own, to
///   the bit, and the face beyond its edge rises out of that by less than 10^-9 of its size: the verdict on tangents
///   did not allow that the edge moves with its face;
/// - line 4 (seed 1, climb 616): by 2.5e-7 of it: the engine moved the edge, for the line in which the face beyond and
///   the hiding one meet was farther from it than roundings of places are, but not of depths;
/// - line 5 (seed 1, climb 3415 of a first mend of that): such a line was taken for the edge's where it is off by more
///   than roundings.
TEST_F(HardPosesCorpus, StatesAtWhichASearchFoundAFaultAreAnsweredAlike) {
  const std::string text = read_text_file(PCM_SOURCE_DIR "/tests/compare/hard_poses/found.json");
  const std::vector<CorpusState> found = corpus_from(text);
  EXPECT_EQ(found.size(), 4U);
  EXPECT_EQ(corpus_text(found), text);
  for (std::size_t i = 0; i < found.size(); ++i) {
    SCOPED_TRACE(name_of(found[i], i));
    const HardState hard = pairs_.hard(found[i]);
    for (const PoseOutcome& outcome : hard.held->hold(hard.state, workspace_))
      for (const Disagreement& d : outcome.disagreements) ADD_FAILURE() << d.text;
  }
}

/// Another engine or another bound may find others harder: search anew (write_corpus.cpp). Margins are of the problem,
/// errors and bounds of the engine's arithmetic; what it counts may change with every saving.
TEST_F(HardPosesCorpus, StatesAreAsHardAsWhenTheyWereFound) {
  std::map<Goal, double> greatest;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const CorpusState& stored = states_[i];
    SCOPED_TRACE(name_of(stored, i));
    const HardState hard = pairs_.hard(stored);
    const double hardness_now = hardness(stored.goal, *hard.held, hard.mode, stored.state, workspace_);
    if (stored.goal == Goal::work || stored.goal == Goal::exact_decisions)
      EXPECT_GE(hardness_now, stored.hardness / 2);
    else
      EXPECT_EQ(hardness_now, stored.hardness);
    greatest[stored.goal] = std::max(greatest[stored.goal], hardness_now);
  }
  EXPECT_GT(greatest[Goal::error_over_bound], 0.5);
  EXPECT_LE(greatest[Goal::error_over_bound], 1);
  EXPECT_GT(greatest[Goal::margins], 0x1p52);
}

}  // namespace
}  // namespace pcm::compare::hard_poses_test
