// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "compare/verify/bounds/part_motion.h"
#include "compare/verify/bounds/question.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// How fast a clipped element's load may grow at most, by r, a turn of F about Mf, v and w, in SI units of force and
/// torque: lengths of the derivatives' vectors. Infinite where nothing is known.
struct GreatestSlopes {
  std::array<double, 12> force{}, torque{};
};

/// Of an element that may be a sliver, as the oracle has it or a right engine, whatever is missing of it. A sliver is
/// small, but not how fast it grows: so no quotient by its area may be taken. With the area A, the volume V = A u, F_d
/// = d_l A f v_n and the fading f = min(1, u / u_d),
///   - A f = min(A, V / u_d), so that its derivative is dA or dV / u_d;
///   - V times the derivative of the centre of pressure is made of those of V and of the moment, and V du = u (dV - u
///     dA); F_n times it is c_l, or d_l v_n / u_d at most, times that;
///   - friction mu F_n (2 - t) t along the slip, t = v_t / v_eps, turns and grows by 2 / v_eps times it at most.
/// Nothing is known of torques, nor where F turns of forces, with damping without u_d; nor where the velocity of slip
/// may change with friction without v_eps. `growth`: of what is seen of its slave face (greatest_part_growth).
GreatestSlopes greatest_slopes_of_sliver(const Question& question, const reference::Element& element,
                                         const ClippedBounds::OfElement& bound, const PartGrowth& growth);

}  // namespace pcm::compare
