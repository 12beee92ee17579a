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

/// F_n before (18) cuts off what pulls, and its derivatives by u_k and by v_n.
template <class Number>
struct NormalForces {
  Number value, by_depth, by_approach;
};

/// (14), (15). Each case is a choice between values that are all computed: what is divided by 0 is not chosen.
template <class Number>
NormalForces<Number> normal_forces(const ContactLaw& law, double c_l, const Number& area, const Number& penetration,
                                   const Number& v_n) {
  const Number zero{};
  const Number elastic = c_l * area * penetration;  // (14)
  const Number viscosity = law.damping * area;
  Number damping = viscosity * v_n;  // (15)
  const auto fades = penetration < law.transition_depth;
  const Number fade = penetration / law.transition_depth;
  Number by_depth = fades ? damping / law.transition_depth : zero;
  Number by_approach = fades ? viscosity * fade : viscosity;
  damping = fades ? damping * fade : damping;
  if (law.damping_mode == DampingMode::compression) {
    const auto parts = v_n < zero;
    damping = parts ? zero : damping;
    by_depth = parts ? zero : by_depth;
    by_approach = parts ? zero : by_approach;
  }
  return {elastic + damping, c_l * area + by_depth, by_approach};
}

/// (14), (15), (18), (20) for elements of area A_k m^2, penetration u_k >= 0 m, approach velocity v_n and slip velocity
/// v_t m/s.
template <class Number>
ElementForces<Number> element_forces(const ContactLaw& law, double c_l, const Number& area, const Number& penetration,
                                     const Number& v_n, const Number& v_t) {
  const Number zero{};
  Number normal = normal_forces(law, c_l, area, penetration, v_n).value;
  const Number pressing = normal < zero ? zero : normal;
  if (law.damping_mode != DampingMode::full) normal = pressing;  // (18)

  // Chosen before it is multiplied on: where it overflows, 0 times it would be no number.
  const Number sliding = v_t > zero ? law.friction * pressing : zero;
  const Number slip = v_t / law.slip_velocity;
  return {normal, v_t >= law.slip_velocity ? sliding : sliding * slip * (2.0 - slip)};  // (20)
}

/// Derivatives of element_forces. At a kink those of one side: of depths from u_d on, v_n >= 0 with
/// DampingMode::compression, forces that press, slip velocities from v_eps on; F_t at rest without v_eps counts as
/// constant.
template <class Number>
struct ElementForceSlopes {
  Number normal_by_depth, normal_by_approach;                              ///< dF_n/du_k, N/m, and dF_n/dv_n, N s/m
  Number tangential_by_depth, tangential_by_approach, tangential_by_slip;  ///< dF_t/du_k, dF_t/dv_n, dF_t/dv_t
  Number tangential_over_slip;                                             ///< F_t / v_t, at rest its limit, N s/m
};

template <class Number>
ElementForceSlopes<Number> element_force_slopes(const ContactLaw& law, double c_l, const Number& area,
                                                const Number& penetration, const Number& v_n, const Number& v_t) {
  const Number zero{};
  const NormalForces<Number> normal = normal_forces(law, c_l, area, penetration, v_n);
  const auto pulls = normal.value < zero;
  const Number limit = pulls ? zero : law.friction * normal.value;
  const Number pressing_by_depth = pulls ? zero : normal.by_depth;
  const Number pressing_by_approach = pulls ? zero : normal.by_approach;
  const bool full = law.damping_mode == DampingMode::full;

  const auto slides = v_t >= law.slip_velocity;
  const Number slip = v_t / law.slip_velocity, one = zero + 1.0;
  const Number share = slides ? (v_t > zero ? one : zero) : slip * (2.0 - slip);  // F_t / (mu F_n) (20)
  return {full ? normal.by_depth : pressing_by_depth,
          full ? normal.by_approach : pressing_by_approach,
          law.friction * pressing_by_depth * share,
          law.friction * pressing_by_approach * share,
          slides ? zero : limit * (2.0 - 2.0 * slip) / law.slip_velocity,
          slides ? (v_t > zero ? limit / v_t : zero) : limit * (2.0 - slip) / law.slip_velocity};
}

}  // namespace

}  // namespace pcm::fast
