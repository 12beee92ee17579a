// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/condition.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshes/generate/boxes.h"

namespace pcm::compare::stability {
namespace {

TEST(Condition, EachNumberOfThePoseIsMovedOnce) {
  Pose pose;
  pose.r = {1, -0.75, 0};
  const std::vector<Pose> moved = poses_an_ulp_away(pose);
  ASSERT_EQ(moved.size(), 12U);
  for (const Pose& there : moved) {
    int changed = 0;
    for (int i = 0; i < 3; ++i) {
      changed += there.r[i] != pose.r[i];
      for (int j = 0; j < 3; ++j) changed += there.A(i, j) != pose.A(i, j);
    }
    EXPECT_EQ(changed, 1);
  }
  EXPECT_EQ(moved[0].r.x(), 1 + 0x1p-52);
  EXPECT_EQ(moved[4].r.y(), -0.75 - 0x1p-53);
  EXPECT_EQ(moved[1].A(0, 0), 1 + 0x1p-52);
}

/// A box on a plate, d deep, its bottom in the plane z = 0 of its frame and the plate's top in z = 1 of Me: by hand,
/// with r_z = 1 - d, whose ulp is 2^-53, and a footprint of a times b.
///   penetration d: moves with r_z alone, by 2^-53;
///   area a b (clipped): moves with a_xx or a_yy, by 2^-52 of itself, or with a_xy or a_yx, by next to nothing;
///   force c_l a b d: the greater of both, relative to itself, which is 2^-53 / d.
class ConditionOfABox : public testing::TestWithParam<double> {};

TEST_P(ConditionOfABox, IsWhatItIsByHand) {
  const double depth = GetParam();
  const ExactBodies bodies(generate::box({-4, -4, -1}, {4, 4, 1}), generate::box({-0.5, -0.25, 0}, {1, 1.25, 2}));
  Pose pose;
  pose.r = {0.375, 0.125, 1 - depth};
  ExactContact truth(bodies, pose, Scheme::clipped);
  const Figures sizes = truth.sizes(), moved = movement_by_an_ulp(bodies, pose, Scheme::clipped, truth);
  const auto relative = [&](Quantity quantity) {
    const auto k = static_cast<std::size_t>(quantity);
    return moved[k] / sizes[k];
  };
  EXPECT_DOUBLE_EQ(relative(Quantity::penetration), 0x1p-53 / depth);
  EXPECT_DOUBLE_EQ(relative(Quantity::force), 0x1p-53 / depth);
  EXPECT_DOUBLE_EQ(relative(Quantity::area), 0x1p-52);
}

INSTANTIATE_TEST_SUITE_P(Depths, ConditionOfABox, testing::Values(0x1p-4, 0x1p-20, 0x1p-45));

}  // namespace
}  // namespace pcm::compare::stability
