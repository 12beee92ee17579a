// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The search for poses at which the engine's error is greatest over its bound: what it finds is harder by far than what
// is drawn, and never harder than the bound allows.
#include "compare/hard_poses/climb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "compare/io/names.h"
#include "fast/base/geometry.h"
#include "tests/compare/hard_poses/corpus.h"

namespace pcm::compare::hard_poses_test {
namespace {

class HardPoses : public testing::TestWithParam<Scheme> {};

TEST_P(HardPoses, AClimbIsAFunctionOfItsRandomNumbersAndEndsAtARotation) {
  const CorpusPairs pairs;
  const HeldPairing& held = pairs.held("cube-cube", GetParam());
  fast::Workspace workspace, fresh;
  const HardPose first = climb(held, PoseRandom(1, 0, 0, 0), workspace);
  climb(held, PoseRandom(1, 0, 0, 1), workspace);
  const HardPose again = climb(held, PoseRandom(1, 0, 0, 0), workspace),
                 alone = climb(held, PoseRandom(1, 0, 0, 0), fresh);
  for (const HardPose& other : {again, alone}) {
    EXPECT_EQ(other.pose.A, first.pose.A);
    EXPECT_EQ(other.pose.r, first.pose.r);
    EXPECT_EQ(other.ratio, first.ratio);
  }
  EXPECT_GT(first.ratio, 0);
  EXPECT_EQ(error_over_bound(held, first.pose, workspace).ratio, first.ratio);
  EXPECT_LE(fast::orthogonality_error(first.pose.A), 1e-10);
}

/// So many poses of each of some pairs, the hardest first.
std::vector<double> ratios(Scheme scheme, const std::function<double(const HeldPairing&, std::uint64_t)>& ratio_of) {
  const CorpusPairs pairs;
  std::vector<double> found;
  for (const char* pair : {"cube-cube", "slab-gridded cube", "wedges", "small icospheres"})
    for (std::uint64_t i = 0; i < 50; ++i) found.push_back(ratio_of(pairs.held(pair, scheme), i));
  std::ranges::sort(found, std::greater());
  return found;
}

TEST_P(HardPoses, TheHundredHardestUseUpTwiceAsMuchOfTheirBoundsAsTheHundredHardestGenericOnes) {
  fast::Workspace workspace;
  const std::vector<double> searched = ratios(GetParam(), [&](const HeldPairing& held, std::uint64_t i) {
    return climb(held, PoseRandom(1, 0, 1, i), workspace).ratio;
  });
  // Of the generic ones, too, only those that are not flipped and carry a force.
  std::map<const HeldPairing*, std::uint64_t> next;
  const std::vector<double> drawn = ratios(GetParam(), [&](const HeldPairing& held, std::uint64_t) {
    ErrorOverBound found;
    do
      found = error_over_bound(
          held, draw_pose(Stratum::generic, held.features(), PoseRandom(1, 0, 2, next[&held]++)).pose, workspace);
    while (found.flipped || found.ratio == 0);
    return found.ratio;
  });
  // Each of them beside the generic one of its rank.
  double least = searched[0] / drawn[0];
  for (std::size_t k = 0; k < 100; ++k) least = std::min(least, searched[k] / drawn[k]);
  EXPECT_GE(least, 2);
  EXPECT_LE(searched.front(), 1);
  for (const std::size_t k : {0, 49, 99})
    std::cout << "number " << k + 1 << ": searched " << searched[k] << ", generic " << drawn[k] << "\n";
  std::cout << "least quotient: " << least << "\n";
}

INSTANTIATE_TEST_SUITE_P(Schemes, HardPoses, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& scheme) { return std::string(name(scheme.param)); });

}  // namespace
}  // namespace pcm::compare::hard_poses_test
