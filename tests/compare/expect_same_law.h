// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "pcm/inputs.h"

namespace pcm::compare {

/// Number by number: not by a text that one function has written of both.
inline void expect_same_law(const ContactLaw& a, const ContactLaw& b) {
  EXPECT_EQ(a.stiffness, b.stiffness);
  ASSERT_EQ(a.layers.has_value(), b.layers.has_value());
  if (a.layers) {
    EXPECT_EQ(a.layers->c_E, b.layers->c_E);
    EXPECT_EQ(a.layers->c_F, b.layers->c_F);
  }
  EXPECT_EQ(a.damping, b.damping);
  EXPECT_EQ(a.transition_depth, b.transition_depth);
  EXPECT_EQ(a.friction, b.friction);
  EXPECT_EQ(a.slip_velocity, b.slip_velocity);
  EXPECT_EQ(a.max_penetration, b.max_penetration);
  EXPECT_EQ(a.damping_mode, b.damping_mode);
}

}  // namespace pcm::compare
