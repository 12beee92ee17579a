// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/recorded_motion.h"

#include <cmath>

namespace pcm::compare {
namespace {

RecordedStep between(const RecordedStep& a, const RecordedStep& b, double share) {
  RecordedStep step;
  for (std::size_t k = 0; k < step.size(); ++k) step[k] = a[k] + share * (b[k] - a[k]);
  return step;
}

/// Where it was so far back, on the line of its velocity, m.
MovingPose moved_back(const MovingPose& state, double way) {
  MovingPose before = state;
  before.pose.r -= ordered_normalized(state.velocity.v) * way;
  return before;
}

}  // namespace

MovingPose state_of(const RecordedStep& step) {
  const auto vector = [&step](std::size_t k) { return Eigen::Vector3d(step[k], step[k + 1], step[k + 2]); };
  return {{ordered_rotation(step[0], step[1], step[2], step[3]), vector(4)}, {vector(7), vector(10)}};
}

DrawnPose draw_along(const std::vector<RecordedStretch>& motion, double size, PoseRandom random) {
  const RecordedStretch& steps = motion[random.below(motion.size())];
  const auto k = static_cast<std::size_t>(random.below(steps.size() - 1));
  const MovingPose asked = state_of(between(steps[k], steps[k + 1], random.uniform()));
  DrawnPose drawn;
  drawn.pose = asked.pose;
  drawn.velocity = asked.velocity;
  drawn.construction = "between recorded steps";
  const MovingPose first = state_of(steps.front());
  if (ordered_dot(first.velocity.v, first.velocity.v) > 0)
    for (const double sizes : {1.0, 0x1p-3, 0x1p-6}) drawn.before.push_back(moved_back(first, sizes * size));
  for (std::size_t i = 0; i <= k; ++i) drawn.before.push_back(state_of(steps[i]));
  return drawn;
}

}  // namespace pcm::compare
