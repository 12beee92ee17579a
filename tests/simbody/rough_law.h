// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pcm/inputs.h"

namespace pcm::simbody {

/// With every term, in the tests' bubbles.
inline ContactLaw rough() {
  ContactLaw law;
  law.stiffness = 5.9e5;
  law.damping = 1000;
  law.transition_depth = 1e-3;
  law.friction = 0.25;
  law.slip_velocity = 1e-2;
  return law;
}

}  // namespace pcm::simbody
