// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "pcm/inputs.h"
#include "tests/force_law.h"

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
  const auto [c_l, share] = written_law::layers<Real>(law, master);
  const Real u_k = std::min(depth, static_cast<Real>(law.max_penetration));
  const RealVector lever = foot + share * u_k * n - pose.r.cast<Real>();
  RealVector v_k = velocity.v.cast<Real>() + velocity.w.cast<Real>().cross(lever);
  if (master == Side::F) v_k = -v_k;
  const Real v_n = n.dot(v_k);
  const RealVector slip = v_k - v_n * n;
  const Real v_t = slip.norm();
  const auto [F_n, F_t] = written_law::forces<Real>(law, c_l, area, u_k, v_n, v_t);
  RealVector force = F_n * n;
  if (v_t > 0) force += F_t * (slip / v_t);
  if (master == Side::F) force = -force;
  return {force, lever.cross(force)};
}

}  // namespace pcm::fast
