// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/colours.h"

#include <gtest/gtest.h>

namespace pcm::simulate {
namespace {

TEST(Colours, OfTheBarGoFromStopToStop) {
  for (std::size_t i = 0; i < kColourStops.size(); ++i)
    EXPECT_EQ(bar_colour(static_cast<double>(i) / 9), kColourStops[i]) << i;
  EXPECT_EQ(bar_colour(-1), kColourStops.front());
  EXPECT_EQ(bar_colour(2), kColourStops.back());
  EXPECT_EQ(bar_colour(0.5), (Rgb{0x23, 0x90, 0x8c}));  // between 26828e and 1f9e89
}

// 0.66 of the sky above and 0.42 of the lamp, times the cosine of its angle: 0.394.
TEST(Colours, AreBrightestTowardsSkyAndLamp) {
  const Eigen::Vector3d up(0, 1, 0);
  EXPECT_EQ(lit({100, 200, 0}, up, up), (Rgb{83, 165, 0}));
  // Only the ground's light, 0.66 times b4bcc6, comes from below.
  EXPECT_EQ(lit({100, 100, 100}, -up, up), (Rgb{47, 49, 51}));
  // Towards lamp and sky it is brighter than 1, which a colour can't be.
  const Eigen::Vector3d to_lamp = Eigen::Vector3d(-0.6, 0.5, 1).normalized();
  EXPECT_EQ(lit({250, 250, 250}, to_lamp, to_lamp), (Rgb{255, 255, 255}));
}

}  // namespace
}  // namespace pcm::simulate
