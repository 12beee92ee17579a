// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/answer.h"
#include "reference/element_source.h"

namespace pcm::reference {

/// A pose and what is asked of the force law about it. Refers to all of it.
struct ForceQuestion {
  const ExactPose& pose;
  const ElementSource& elements;
  const ContactLaw& law;
  Mode mode;
  const Velocity& velocity;

  /// What totals over all masters are multiplied by.
  double share() const { return mode == Mode::both ? 0.5 : 1.0; }
};

/// Writes elements (where `wanted.elements`), force, torque, their scales and the greatest penetration: PCM (1)-(24).
/// The question's elements are those of all masters evaluated, E's first; in mode `both` force, torque and scales are
/// halved, the elements listed are not.
///
/// Every value is enclosed first, to 120 and 240 bits. Where an enclosure does not round to one double, or does not
/// decide a case of the law, the value is computed exactly, as a sum of square roots of rationals (exact_loads.h,
/// radical_sum.h). So all values are correctly rounded, ties to even and zero as +0, with two exceptions. The scales
/// are middles of enclosures of 240 bits or more where those do not round to one double. And roots of roots, which
/// friction brings in with w != 0 where a u_k is clamped to max_penetration, are enclosed to 4096 bits and no further.
void report_force(const ForceQuestion& question, const Wanted& wanted, Answer& answer);

}  // namespace pcm::reference
