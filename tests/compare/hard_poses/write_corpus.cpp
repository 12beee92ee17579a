// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the corpus of hard states: of each pair, scheme and goal those that are hardest of some climbs. Some minutes:
//
//   ninja -C build/release write_hard_poses
//   build/release/tests/compare/write_hard_poses > tests/compare/hard_poses/corpus.json
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <iostream>

#include "compare/hard_poses/climb.h"
#include "tests/compare/hard_poses/corpus.h"

namespace pcm::compare::hard_poses_test {
namespace {

constexpr std::uint64_t kSeed = 19, kClimbs = 12;
constexpr std::size_t kHardest = 2;

CorpusState corpus_state(const SurfacePair& pair, Goal goal, const Climb& climbed) {
  const HardState& hard = climbed.hardest;
  reference::Inquiry inquiry(hard.held->oracle(), hard.state.pose, hard.state.velocity, {}, hard.state.law,
                             hard.state.scheme);
  const reference::Answer truth = inquiry.answer(reference::Problem::exact, hard.mode_asked());
  return {
      pair.name,      moved_vertices(pair, hard), hard.mode_asked(), hard.state, goal, climbed.reached, truth.force_Me,
      truth.torque_Me};
}

std::vector<CorpusState> hardest_of(const SurfacePair& pair, Goal goal, Scheme scheme) {
  const HardState surfaces = hard_state(pair.E, pair.F, scheme);
  std::vector<CorpusState> found(kClimbs);
  oneapi::tbb::parallel_for(std::uint64_t{0}, kClimbs, [&](std::uint64_t i) {
    fast::Workspace workspace;
    const PoseRandom random(kSeed, static_cast<std::uint64_t>(goal), static_cast<std::uint64_t>(scheme), i);
    found[i] = corpus_state(pair, goal, climb(goal, surfaces, random, workspace));
  });
  std::ranges::stable_sort(found, std::greater(), &CorpusState::hardness);
  found.resize(kHardest);
  return found;
}

void search() {
  const CorpusPairs pairs;
  std::vector<CorpusState> corpus;
  for (const std::string& pair : pairs.names())
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped})
      for (const Goal goal : kGoals)
        for (CorpusState& hard : hardest_of(pairs.surfaces(pair), goal, scheme)) corpus.push_back(std::move(hard));
  std::cout << corpus_text(corpus);
}

}  // namespace
}  // namespace pcm::compare::hard_poses_test

int main() {
  pcm::compare::hard_poses_test::search();
}
