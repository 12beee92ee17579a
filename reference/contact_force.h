// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/answer.h"
#include "reference/element_source.h"

namespace pcm::reference {

/// Writes elements (where `wanted.elements`), force, torque, their scales and the greatest penetration: PCM (1)-(24).
/// `elements` hold those of all masters evaluated, E's first; in mode `both` force, torque and scales are halved, the
/// elements listed are not.
///
/// Every value is enclosed and the enclosure refined until both ends round to the same double. A component that is not
/// exactly representable in the enclosure's arithmetic but zero, or midway between two doubles, is never settled that
/// way: at the last precision (1280 bits) the middle is reported, 0 where the enclosure holds 0. That is not a proof.
void report_force(const ExactPose& pose, const ElementSource& elements, const ContactLaw& law, Mode mode,
                  const Velocity& velocity, const Wanted& wanted, Answer& answer);

}  // namespace pcm::reference
