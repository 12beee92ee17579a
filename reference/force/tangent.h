// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/force/force_question.h"

namespace pcm::reference {

/// The derivatives of force (23) and torque (24) of all masters together by the twelve coordinates of the relative
/// state, by forward differentiation of the same sums; with two masters, halved. All of one pose, law and velocity.
///
/// The vertices of F move as its body does, dx = dr + a x (x - r) for a turn a about Mf, in either problem. Where the
/// law has a kink, it is that of one side (docs/PCM.md section 7.1).
Tangent tangent_of(const std::vector<ForceQuestion>& masters);

}  // namespace pcm::reference
