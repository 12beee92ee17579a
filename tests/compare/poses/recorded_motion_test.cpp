// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// States between recorded steps: functions of the recording and of the random numbers alone, with the way they came.
#include "compare/poses/recorded_motion.h"

#include <gtest/gtest.h>

#include "fast/base/geometry.h"

namespace pcm::compare {
namespace {

/// Down along z, while it turns about z.
RecordedStretch falling() {
  return {{1, 0, 0, 0, 0.5, 0, 1, 0, 0, -2, 0, 0, 8},
          {0.9, 0, 0, 0.4, 0.5, 0, 0.75, 0, 0, -4, 0, 0, 8},
          {0.6, 0, 0, 0.8, 0.5, 0, 0.25, 0, 0, -6, 0, 0, 8}};
}

PoseRandom random_for(std::uint64_t pose) {
  return {7, static_cast<std::uint64_t>(Stratum::trajectory), 3, pose};
}

void expect_same(const DrawnPose& a, const DrawnPose& b) {
  EXPECT_EQ(a.pose.A, b.pose.A);
  EXPECT_EQ(a.pose.r, b.pose.r);
  EXPECT_EQ(a.velocity.v, b.velocity.v);
  EXPECT_EQ(a.velocity.w, b.velocity.w);
  ASSERT_EQ(a.before.size(), b.before.size());
  for (std::size_t i = 0; i < a.before.size(); ++i) EXPECT_EQ(a.before[i].pose.r, b.before[i].pose.r);
}

TEST(RecordedMotion, QuaternionsNeedNotBeOfLengthOne) {
  const RecordedStep unit{0.6, 0, 0, 0.8, 1, 2, 3, 4, 5, 6, 7, 8, 9}, twice{1.2, 0, 0, 1.6, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const MovingPose state = state_of(unit);
  EXPECT_EQ(state.pose.A, state_of(twice).pose.A);
  EXPECT_NEAR(state.pose.A(1, 0), 0.96, 1e-15);
  EXPECT_NEAR(state.pose.A(0, 0), -0.28, 1e-15);
  EXPECT_EQ(state.pose.r, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(state.velocity.v, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(state.velocity.w, Eigen::Vector3d(7, 8, 9));
}

TEST(RecordedMotion, PosesLieBetweenStepsAndDoNotHangOnWhatWasDrawnBefore) {
  const std::vector<RecordedStretch> motion{falling()};
  const DrawnPose first = draw_along(motion, 2, random_for(0));
  int of_second_step = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const DrawnPose drawn = draw_along(motion, 2, random_for(i));
    const double z = drawn.pose.r.z();
    EXPECT_LE(z, 1);
    EXPECT_GE(z, 0.25);
    EXPECT_LE(fast::orthogonality_error(drawn.pose.A), 24 * 0x1p-53);
    const bool is_second = drawn.before.size() == 5;
    EXPECT_EQ(drawn.before.size(), is_second ? 5U : 4U);
    EXPECT_EQ(z < 0.75, is_second) << z;
    EXPECT_EQ(drawn.velocity.w, Eigen::Vector3d(0, 0, 8));
    of_second_step += is_second;
  }
  EXPECT_NEAR(of_second_step, 100, 60);
  expect_same(draw_along(motion, 2, random_for(0)), first);
}

TEST(RecordedMotion, ComesAlongTheLineOfItsFirstVelocityAndThenStepByStep) {
  const std::vector<RecordedStretch> motion{falling()};
  DrawnPose drawn;
  for (std::uint64_t i = 0; drawn.before.size() < 5; ++i) drawn = draw_along(motion, 2, random_for(i));
  const double heights[] = {1 + 2, 1 + 2.0 / 8, 1 + 2.0 / 64, 1, 0.75};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(drawn.before[i].pose.r, Eigen::Vector3d(0.5, 0, heights[i]));
  EXPECT_EQ(drawn.before[2].velocity.v, Eigen::Vector3d(0, 0, -2));
  EXPECT_EQ(drawn.before[4].velocity.v, Eigen::Vector3d(0, 0, -4));
}

TEST(RecordedMotion, WhatWasAtRestComesFromNowhere) {
  RecordedStretch steps = falling();
  for (std::size_t k = 7; k < 10; ++k) steps.front()[k] = 0;
  steps.pop_back();
  const DrawnPose drawn = draw_along({steps}, 2, random_for(0));
  ASSERT_EQ(drawn.before.size(), 1U);
  EXPECT_EQ(drawn.before[0].pose.r, Eigen::Vector3d(0.5, 0, 1));
}

}  // namespace
}  // namespace pcm::compare
