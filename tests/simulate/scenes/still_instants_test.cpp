// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/still_instants.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pcm::simulate {
namespace {

TEST(Stills, TwoInstantsNeverShareAName) {
  EXPECT_EQ(still_name(0.4), "still_0.4.png");
  EXPECT_EQ(still_name(3), "still_3.png");
  EXPECT_EQ(still_name(-0.0), "still_0.png");
  EXPECT_NE(still_name(0.4), still_name(std::nextafter(0.4, 1)));
}

}  // namespace
}  // namespace pcm::simulate
