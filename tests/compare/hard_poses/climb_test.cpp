// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The search for states that are hard: what it finds is harder by far than what is drawn, and never harder than the
// bound allows.
#include "compare/hard_poses/climb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/hard_poses/neighbour.h"
#include "compare/io/names.h"
#include "compare/verify/routes/state_draw.h"
#include "fast/base/geometry.h"
#include "tests/compare/hard_poses/corpus.h"

namespace pcm::compare::hard_poses_test {
namespace {

HardState surfaces_of(const SurfacePair& pair, Scheme scheme) {
  return hard_state(pair.E, pair.F, scheme);
}

std::string text_of(const HardState& hard) {
  return format_case(as_case(hard, "here"), {}, {});
}

class HardPoses : public testing::TestWithParam<Scheme> {};

TEST_P(HardPoses, AClimbToAnyGoalIsAFunctionOfItsRandomNumbersAndEndsWhereItSays) {
  const CorpusPairs pairs;
  const HardState surfaces = surfaces_of(pairs.surfaces("cube-cube"), GetParam());
  fast::Workspace workspace;
  for (const Goal goal : kGoals) {
    SCOPED_TRACE(name(goal));
    fast::Workspace fresh;
    const Climb first = climb(goal, surfaces, PoseRandom(1, 0, 0, 0), workspace),
                other = climb(goal, surfaces, PoseRandom(1, 0, 0, 1), workspace),
                again = climb(goal, surfaces, PoseRandom(1, 0, 0, 0), workspace),
                alone = climb(goal, surfaces, PoseRandom(1, 0, 0, 0), fresh);
    EXPECT_NE(text_of(other.hardest), text_of(first.hardest));
    for (const Climb& same : {again, alone}) {
      EXPECT_EQ(text_of(same.hardest), text_of(first.hardest));
      EXPECT_EQ(same.begun_at, first.begun_at);
      EXPECT_EQ(same.reached, first.reached);
    }
    EXPECT_GT(first.reached, 0);
    EXPECT_GE(first.reached, first.begun_at);
    const HardState& end = first.hardest;
    EXPECT_EQ(hardness(goal, *end.held, end.mode, end.state, workspace), first.reached);
    EXPECT_LE(fast::orthogonality_error(end.state.pose.A), 1e-9);  // near-degenerate poses are as far off
    EXPECT_EQ(end.state.scheme, GetParam());
  }
}

/// So many states of each of some pairs, the hardest first.
std::vector<double> ratios(Scheme scheme, const std::function<double(const HardState&, std::uint64_t)>& ratio_of) {
  const CorpusPairs pairs;
  std::vector<double> found;
  for (const char* pair : {"cube-cube", "slab-gridded cube", "wedges", "small icospheres"}) {
    const HardState surfaces = surfaces_of(pairs.surfaces(pair), scheme);
    for (std::uint64_t i = 0; i < 50; ++i) found.push_back(ratio_of(surfaces, i));
  }
  std::ranges::sort(found, std::greater());
  return found;
}

/// Of the next generic state, under a law and with a velocity drawn for it, that is not flipped and carries a force.
double ratio_of_generic(const HardState& surfaces, std::uint64_t& next, fast::Workspace& workspace) {
  for (;;) {
    const std::uint64_t i = next++;
    const auto stream = [i](Purpose purpose) { return PoseRandom(1, 0, 2, i, purpose); };
    const DrawnPose drawn = draw_pose(Stratum::generic, surfaces.held->features(), stream(Purpose::pose));
    const HeldPairing::State state = draw_state(*surfaces.held, Stratum::generic, drawn, surfaces.state.scheme,
                                                stream(Purpose::law), stream(Purpose::velocity));
    const double ratio = hardness(Goal::error_over_bound, *surfaces.held, i % 3, state, workspace);
    if (ratio > 0) return ratio;
  }
}

TEST_P(HardPoses, TheHundredHardestUseUpTwiceAsMuchOfTheirBoundsAsTheHundredHardestGenericOnes) {
  fast::Workspace workspace;
  const std::vector<double> searched = ratios(GetParam(), [&](const HardState& surfaces, std::uint64_t i) {
    return climb(Goal::error_over_bound, surfaces, PoseRandom(1, 0, 1, i), workspace).reached;
  });
  std::map<const HeldPairing*, std::uint64_t> next;
  const std::vector<double> drawn = ratios(GetParam(), [&](const HardState& surfaces, std::uint64_t) {
    return ratio_of_generic(surfaces, next[surfaces.held.get()], workspace);
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
