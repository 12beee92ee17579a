// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pcm/inputs.h"
#include "reference/elements/element_source.h"
#include "reference/pose/exact_pose.h"

namespace pcm::reference {

/// One master's elements in a pose and what is asked of the force law about them. Refers to all of it.
struct ForceQuestion {
  const ExactPose& pose;
  const ElementSource& elements;
  const ContactLaw& law;
  const Velocity& velocity;
};

}  // namespace pcm::reference
