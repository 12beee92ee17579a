// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/force/force_question.h"
#include "reference/numbers/double_double.h"
#include "reference/numbers/vector3.h"

namespace pcm::reference {

/// What the elements of one master add to a derivative of force (23) and torque (24).
template <class T>
struct LoadSlope {
  Vec3<T> force, torque;
};

/// The derivatives of one master's force and torque by the twelve coordinates of the relative state, by forward
/// differentiation of the sums that they are, and how its elements move.
///
/// The vertices of F move as its body does, dx = dr + a x (x - r) for a turn a about Mf, in either problem. Where the
/// law has a kink, it is that of one side (docs/PCM.md section 7.1).
struct MasterTangent {
  std::vector<LoadSlope<DoubleDouble>> by_coordinate;
  std::vector<ElementMotion> elements;

  explicit MasterTangent(const ForceQuestion& question);
};

/// Of all masters together; with two of them, halved. All of one pose, law and velocity.
Tangent tangent_of(const std::vector<const MasterTangent*>& masters);

}  // namespace pcm::reference
