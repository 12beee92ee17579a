// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The hardest poses known, replayed: the engine within its bound of the answers that are stored, by all routes, and as
// near to ties and to that bound as when they were found.
#include "tests/compare/hard_poses/corpus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/hard_poses/error_over_bound.h"
#include "compare/io/names.h"
#include "meshes/files/text_file.h"
#include "tests/compare/least_margins.h"

namespace pcm::compare::hard_poses_test {
namespace {

class HardPosesCorpus : public testing::Test {
 protected:
  const std::string text_ = read_text_file(PCM_SOURCE_DIR "/tests/compare/hard_poses/corpus.json");
  const std::vector<CorpusPose> poses_ = corpus_from(text_);
  const CorpusPairs pairs_;
  fast::Workspace workspace_;
};

std::string name_of(const CorpusPose& pose, std::size_t number) {
  return "line " + std::to_string(number + 2) + ", " + pose.pair + ", " + std::string(name(pose.scheme));
}

TEST_F(HardPosesCorpus, HoldsPosesOfBothKindsAndSchemes) {
  std::set<std::pair<std::string, Scheme>> kinds;
  for (const CorpusPose& pose : poses_) kinds.insert({pose.hard_for, pose.scheme});
  EXPECT_EQ(kinds.size(), 4U);
  EXPECT_GE(poses_.size(), 80U);
  EXPECT_EQ(corpus_text(poses_), text_);
}

TEST_F(HardPosesCorpus, EngineIsWithinItsBoundOfTheStoredTruth) {
  Wanted wanted;
  wanted.bound = true;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const CorpusPose& pose = poses_[i];
    SCOPED_TRACE(name_of(pose, i));
    const HeldPairing& held = pairs_.held(pose.pair, pose.scheme);
    const fast::Contact& subj = fast::evaluate(held.engine(), pose.pose, {}, wanted, workspace_);
    for (int j = 0; j < 3; ++j) {
      EXPECT_LE(std::abs(subj.force_Me[j] - pose.true_force_Me[j]), subj.bound->force_Me[j]);
      EXPECT_LE(std::abs(subj.torque_Me[j] - pose.true_torque_Me[j]), subj.bound->torque_Me[j]);
    }
  }
}

TEST_F(HardPosesCorpus, OracleAnswersAsStoredAndEveryRouteAgrees) {
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const CorpusPose& pose = poses_[i];
    SCOPED_TRACE(name_of(pose, i));
    const HeldPairing& held = pairs_.held(pose.pair, pose.scheme);
    reference::Inquiry inquiry(held.oracle(), pose.pose);
    const reference::Answer truth = inquiry.answer(reference::Problem::exact);
    EXPECT_EQ(truth.force_Me, pose.true_force_Me);
    EXPECT_EQ(truth.torque_Me, pose.true_torque_Me);
    const PoseOutcome outcome = held.hold(pose.pose, {}, workspace_).front();
    for (const Disagreement& d : outcome.disagreements) ADD_FAILURE() << d.text;
  }
}

/// Another engine or another bound may have other ratios, and then other hardest poses: search anew
/// (write_corpus.cpp).
TEST_F(HardPosesCorpus, MarginsAndErrorsOverBoundsAreAsStored) {
  double greatest = 0, least = 1;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const CorpusPose& pose = poses_[i];
    SCOPED_TRACE(name_of(pose, i));
    const HeldPairing& held = pairs_.held(pose.pair, pose.scheme);
    EXPECT_EQ(least_margins(held.features(), pose.pose).front(), pose.margin);
    EXPECT_EQ(error_over_bound(held, pose.pose, workspace_).ratio, pose.error_over_bound);
    greatest = std::max(greatest, pose.error_over_bound);
    least = std::min(least, pose.margin);
  }
  EXPECT_GT(greatest, 0.5);
  EXPECT_LT(least, 0x1p-52);
}

}  // namespace
}  // namespace pcm::compare::hard_poses_test
