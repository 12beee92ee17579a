// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pcm/inputs.h"

namespace pcm::compare {

/// A law with everything in it, but no threshold that elements are just at.
inline ContactLaw law_of_all() {
  ContactLaw law;
  law.layers = LayerStiffness{3e6, 1e6};
  law.damping = 300;
  law.transition_depth = 0.01;
  law.friction = 0.3;
  law.slip_velocity = 0.5;
  return law;
}

}  // namespace pcm::compare
