// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "pcm/inputs.h"

/// The force law of PCM section 7 as it is written there, in numbers of any kind, which engine, oracle and bounds on
/// errors are held to.
namespace pcm::written_law {

template <class Real>
struct Layers {
  Real c_l;          ///< (12), N/m^3
  Real slave_share;  ///< c_slave / (c_E + c_F): how far C_k lies from the master face, in parts of u_k (13)
};

template <class Real>
Layers<Real> layers(const ContactLaw& law, Side master) {
  if (!law.layers) return {Real(law.stiffness), Real(0.5)};
  const double c_master = master == Side::E ? law.layers->c_E : law.layers->c_F;
  const double c_slave = master == Side::E ? law.layers->c_F : law.layers->c_E;
  if (std::isinf(c_master)) return {Real(c_slave), Real(0)};
  if (std::isinf(c_slave)) return {Real(c_master), Real(1)};
  const Real sum = Real(c_master) + Real(c_slave);
  return {Real(Real(c_master) * Real(c_slave) / sum), Real(Real(c_slave) / sum)};
}

template <class Real>
struct Forces {
  Real normal;      ///< F_n (18), N
  Real tangential;  ///< F_t (20), N
};

/// Of an element of area A_k, m^2, penetration u_k, m, approach and slip velocity v_n and v_t, m/s.
template <class Real>
Forces<Real> forces(const ContactLaw& law, const Real& c_l, const Real& A_k, const Real& u_k, const Real& v_n,
                    const Real& v_t) {
  const Real zero(0);
  Real F_d = Real(law.damping) * A_k * v_n;  // (15)
  if (u_k < law.transition_depth) F_d = F_d * u_k / Real(law.transition_depth);
  if (law.damping_mode == DampingMode::compression && F_d < zero) F_d = zero;
  Real F_n = c_l * A_k * u_k + F_d;  // (14), (18)
  if (law.damping_mode == DampingMode::no_tension && F_n < zero) F_n = zero;
  if (!(F_n > zero) || !(v_t > zero)) return {F_n, zero};
  const Real v_eps(law.slip_velocity);
  const Real share = v_t < v_eps ? Real(v_t / v_eps * (2 - v_t / v_eps)) : Real(1);
  return {F_n, Real(Real(law.friction) * F_n * share)};  // (20)
}

}  // namespace pcm::written_law
