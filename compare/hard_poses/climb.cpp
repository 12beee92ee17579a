// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/climb.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "compare/hard_poses/neighbour.h"
#include "compare/verify/routes/state_draw.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

constexpr std::uint64_t kStarts = 64;
constexpr int kNeighbours = 384;

constexpr std::array kStartsFrom = {Stratum::generic, Stratum::grazing, Stratum::degenerate, Stratum::near_degenerate,
                                    Stratum::adversarial};

/// None, -1, where engine or oracle refuses; infinite where either breaks down.
double hardness_or_none(Goal goal, const HardState& hard, fast::Workspace& workspace) {
  try {
    return hardness(goal, *hard.held, hard.mode, hard.state, workspace);
  } catch (const BadInput&) {
    return -1;
  } catch (const std::exception&) {
    return std::numeric_limits<double>::infinity();
  }
}

/// What broke down while a law was drawn is asked itself.
HardState broken_down(const HardState& from, const DrawFailure& failure) {
  HardState hard = from;
  hard.state = failure.state();
  hard.ask_in(Mode::both);
  return hard;
}

HardState draw_start(Goal goal, const HardState& surfaces, std::uint64_t number, PoseRandom& random) {
  const Stratum stratum = kStartsFrom[number % kStartsFrom.size()];
  const std::uint64_t seed = random.bits();
  const auto stream = [seed](Purpose purpose) { return PoseRandom(seed, 0, 0, 0, purpose); };
  HardState start = surfaces;
  start.mode = random.below(3);
  const DrawnPose drawn = draw_pose(stratum, surfaces.held->features(), stream(Purpose::pose));
  start.state.pose = drawn.pose;
  if (!depends_on_law(goal)) return start;
  try {
    start.state = draw_state(*surfaces.held, stratum, drawn, surfaces.state.scheme, stream(Purpose::law),
                             stream(Purpose::velocity));
  } catch (const DrawFailure& failure) {
    return broken_down(surfaces, failure);
  }
  return start;
}

}  // namespace

Climb climb_from(Goal goal, const HardState& start, PoseRandom random, fast::Workspace& workspace) {
  const double begun_at = hardness_or_none(goal, start, workspace);
  Climb climbed{start, begun_at, begun_at};
  for (int i = 0; i < kNeighbours && !std::isinf(climbed.reached); ++i) {
    HardState near;
    try {
      near = neighbour(climbed.hardest, goal, random);
    } catch (const BadInput&) {
      continue;
    } catch (const DrawFailure& failure) {
      near = broken_down(climbed.hardest, failure);
    }
    const double reached = hardness_or_none(goal, near, workspace);
    if (reached < climbed.reached) continue;
    climbed.hardest = std::move(near);
    climbed.reached = reached;
  }
  return climbed;
}

Climb climb(Goal goal, const HardState& surfaces, PoseRandom random, fast::Workspace& workspace) {
  HardState hardest = surfaces;
  double greatest = -1;
  for (std::uint64_t i = 0; i < kStarts; ++i) {
    HardState start = draw_start(goal, surfaces, i, random);
    const double there = hardness_or_none(goal, start, workspace);
    if (i > 0 && there <= greatest) continue;
    hardest = std::move(start);
    greatest = there;
  }
  return climb_from(goal, hardest, random, workspace);
}

}  // namespace pcm::compare
