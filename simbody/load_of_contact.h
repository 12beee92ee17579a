// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pcm/contact.h"
#include "pcm/inputs.h"
#include "pcm/load_tangent.h"

namespace pcm::simbody {

/// Nothing but force and torque: what the equations of motion need.
inline constexpr Wanted kLoadAlone{false, false, true, false, false, false};

inline Load load_of(const fast::Contact& contact) {
  Load load;
  load << contact.force_Me, contact.torque_Me;
  return load;
}

}  // namespace pcm::simbody
