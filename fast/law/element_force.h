// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
// The formulas of the force law, once for a double and for a vector of them, an element a lane. For files that are
// compiled for different instructions: everything here is local to the file that includes it, and no function of
// another header is called, so that no wide instruction leaks out.
//
// Who changes them changes their error (fast/bounds/law_error.cpp), the oracle's own law (reference/force/law.h), the
// verdict's (compare/verify/bounds/element_law.cpp) and the tests' (tests/force_law.h), each written apart from the
// others so that an error in one shows; tests/architecture/force_law_test.cpp looks for a sixth place.
// Then section 7 of docs/PCM.md, and numbers known in closed form (compare/known_answers, worked examples in tests).
#pragma once

#include "pcm/inputs.h"

namespace pcm::fast {

namespace {

/// Of each element, from the master's point of view.
template <class Number>
struct ElementForces {
  Number normal;      ///< F_n (18), N
  Number tangential;  ///< F_t (20), N
};

/// (14), (15), (18), (20) for elements of area A_k m^2, penetration u_k > 0 m, approach velocity v_n and slip velocity
/// v_t m/s. Each case is a choice between values that are all computed: what is divided by 0 is not chosen.
template <class Number>
ElementForces<Number> element_forces(const ContactLaw& law, double c_l, const Number& area, const Number& penetration,
                                     const Number& v_n, const Number& v_t) {
  const Number zero{};
  const Number elastic = c_l * area * penetration;  // (14)
  Number damping = law.damping * area * v_n;        // (15)
  damping = penetration < law.transition_depth ? damping * (penetration / law.transition_depth) : damping;
  if (law.damping_mode == DampingMode::compression) damping = v_n < zero ? zero : damping;
  Number normal = elastic + damping;
  const Number pressing = normal < zero ? zero : normal;
  if (law.damping_mode != DampingMode::full) normal = pressing;  // (18)

  // Chosen before it is multiplied on: where it overflows, 0 times it would be no number.
  const Number sliding = v_t > zero ? law.friction * pressing : zero;
  const Number slip = v_t / law.slip_velocity;
  return {normal, v_t >= law.slip_velocity ? sliding : sliding * slip * (2.0 - slip)};  // (20)
}

}  // namespace

}  // namespace pcm::fast
