// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pcm/inputs.h"

namespace pcm::reference {

/// Throws BadInput where the pose is no rotation to 1e-9, or anything is not finite.
void require_fit(const Pose& pose, const Velocity& velocity);

/// Throws BadInput where a parameter is out of its range (fast/include/pcm/inputs.h).
void require_fit(const ContactLaw& law);

}  // namespace pcm::reference
