// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the corpus of hard poses: of each pair and scheme the poses that climbs brought nearest to the bound, and
// those of the stratum adversarial that carry a force and have the least margins. Some minutes:
//
//   ninja -C build/release write_hard_poses
//   build/release/tests/compare/write_hard_poses > tests/compare/hard_poses/corpus.json
#include <algorithm>
#include <iostream>

#include "compare/hard_poses/climb.h"
#include "tests/compare/hard_poses/corpus.h"
#include "tests/compare/least_margins.h"

namespace pcm::compare::hard_poses_test {
namespace {

constexpr std::uint64_t kSeed = 19, kClimbs = 40, kNearTies = 200;
constexpr std::size_t kOfBound = 4, kOfMargins = 2;

CorpusPose posed(const std::string& pair, const HeldPairing& held, const char* hard_for, const Pose& pose,
                 fast::Workspace& workspace) {
  reference::Inquiry inquiry(held.oracle(), pose);
  const reference::Answer truth = inquiry.answer(reference::Problem::exact);
  return {pair,
          held.engine().scheme(),
          hard_for,
          pose,
          truth.force_Me,
          truth.torque_Me,
          least_margins(held.features(), pose).front(),
          error_over_bound(held, pose, workspace).ratio};
}

void add_hardest(std::vector<CorpusPose>& found, std::size_t most,
                 bool (*is_harder)(const CorpusPose&, const CorpusPose&), std::vector<CorpusPose>& corpus) {
  std::ranges::stable_sort(found, is_harder);
  found.resize(std::min(most, found.size()));
  corpus.insert(corpus.end(), found.begin(), found.end());
}

void search() {
  const CorpusPairs pairs;
  fast::Workspace workspace;
  std::vector<CorpusPose> corpus;
  for (const std::string& pair : searched_pairs())
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
      const HeldPairing& held = pairs.held(pair, scheme);
      std::vector<CorpusPose> climbed, near_ties;
      for (std::uint64_t i = 0; i < kClimbs; ++i) {
        const HardPose hard = climb(held, PoseRandom(kSeed, 0, 0, i), workspace);
        if (hard.ratio > 0) climbed.push_back(posed(pair, held, "bound", hard.pose, workspace));
      }
      for (std::uint64_t i = 0; i < kNearTies; ++i) {
        const PoseRandom random(kSeed, static_cast<std::uint64_t>(Stratum::adversarial),
                                static_cast<std::uint64_t>(scheme), i);
        const Pose pose = draw_pose(Stratum::adversarial, held.features(), random).pose;
        CorpusPose near_tie = posed(pair, held, "margins", pose, workspace);
        if (!near_tie.true_force_Me.isZero(0)) near_ties.push_back(std::move(near_tie));
      }
      add_hardest(
          climbed, kOfBound,
          [](const CorpusPose& a, const CorpusPose& b) { return a.error_over_bound > b.error_over_bound; }, corpus);
      add_hardest(
          near_ties, kOfMargins, [](const CorpusPose& a, const CorpusPose& b) { return a.margin < b.margin; }, corpus);
    }
  std::cout << corpus_text(corpus);
}

}  // namespace
}  // namespace pcm::compare::hard_poses_test

int main() {
  pcm::compare::hard_poses_test::search();
}
