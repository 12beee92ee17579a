// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "pcm/inputs.h"

/// The force law in long double, which the bounds on its errors are held to.
namespace pcm::fast {

using Real = long double;
using RealVector = Eigen::Matrix<Real, 3, 1>;

struct TrueForce {
  RealVector force, torque;
};

/// PCM (12)-(22) as they are written there.
inline TrueForce true_force(const ContactLaw& law, const Pose& pose, const Velocity& velocity, Side master, Real area,
                            Real depth, const RealVector& n, const RealVector& foot) {
  Real c_l = law.stiffness, share = 0.5L;
  if (law.layers) {
    const Real c_E = law.layers->c_E, c_F = law.layers->c_F;
    c_l = std::isinf(c_F) ? c_E : c_E * c_F / (c_E + c_F);
    share = std::isinf(c_F) ? (master == Side::E ? 1 : 0) : (master == Side::E ? c_F : c_E) / (c_E + c_F);
  }
  const Real u_k = std::min(depth, static_cast<Real>(law.max_penetration));
  const RealVector lever = foot + share * u_k * n - pose.r.cast<Real>();
  RealVector v_k = velocity.v.cast<Real>() + velocity.w.cast<Real>().cross(lever);
  if (master == Side::F) v_k = -v_k;
  const Real v_n = n.dot(v_k);
  const RealVector slip = v_k - v_n * n;
  const Real v_t = slip.norm();
  const Real fade = u_k < law.transition_depth ? u_k / law.transition_depth : 1;
  Real damping = law.damping * area * v_n * fade;
  if (law.damping_mode == DampingMode::compression) damping = std::max(damping, Real(0));
  Real F_n = c_l * area * u_k + damping;
  if (law.damping_mode == DampingMode::no_tension) F_n = std::max(F_n, Real(0));
  Real F_t = law.friction * std::max(F_n, Real(0));
  if (v_t < law.slip_velocity) F_t *= v_t / law.slip_velocity * (2 - v_t / law.slip_velocity);
  RealVector force = F_n * n;
  if (v_t > 0) force += F_t * (slip / v_t);
  if (master == Side::F) force = -force;
  return {force, lever.cross(force)};
}

}  // namespace pcm::fast
