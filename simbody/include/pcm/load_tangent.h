// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "pcm/engine.h"
#include "pcm/inputs.h"

namespace pcm::simbody {

/// What a pairing does: force on E's body, N, then torque on it about Mf, N m, both in Me.
using Load = Eigen::Matrix<double, 6, 1>;

/// How far a pairing is moved for its tangent. Far less than the slip velocity and the depth: a body that rolls or
/// turns about its contact moves its origin and turns so that the contact rests, and two great slopes, of friction by v
/// and by w, must cancel; forward differences of friction are each off by increment / v_eps of them. What would be lost
/// in rounding is not taken: at least sqrt(eps) |r|, sqrt(eps) rad, sqrt(eps) |v|, sqrt(eps) |w|, of the pose and
/// velocity where the pairing is.
struct TangentIncrements {
  double length = 1e-8;         ///< m
  double angle = 1e-8;          ///< rad
  double speed = 1e-8;          ///< m/s
  double angular_speed = 1e-8;  ///< rad/s
};

/// A pairing's load to first order about a pose (A_0, r_0) and a velocity (v_0, w_0) of Mf seen from Me, resolved in
/// Me:
///
///     load + slope (r - r_0, a, v - v_0, w - w_0),
///
/// where a is the vector of the rotation A A_0^T, about Mf's origin. Load and coordinates are relative: that both
/// bodies move as one changes nothing in Me.
struct LoadTangent {
  Pose pose;
  Velocity velocity;
  Load load = Load::Zero();
  Eigen::Matrix<double, 6, 12> slope = Eigen::Matrix<double, 6, 12>::Zero();

  /// The load by the tangent. For a rotation by phi, a is taken sin(phi) long, which is off by at most phi^3 / 6.
  Load at(const Pose& to, const Velocity& at_velocity) const;
};

/// A tangent, or why there is none, and what was asked of the engine for it.
struct TangentAnswer {
  /// False where a pose is of no use on both sides of the given one along some coordinate: nested, or deeper than
  /// max_penetration of the law.
  bool exists = true;
  LoadTangent tangent;
  int whole = 0;     ///< evaluations
  int law_only = 0;  ///< evaluations at a pose that was known, by the law alone
};

/// By forward differences; backward ones along coordinates whose pose ahead is of no use. `load` is what the engine
/// has for this pose and velocity, where the surfaces touch and nothing is nested nor too deep.
///
/// 12 evaluations: whole ones at 6 poses, and at one that 6 velocities share; the other 5 by the law alone. Each pose
/// that is of no use costs a whole one more. The error is half of the increment times the load's second derivative, and
/// rounding of the load over the increment. Throws as fast::evaluate does.
TangentAnswer load_tangent(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity, const Load& load,
                           const TangentIncrements& increments, fast::Workspace& workspace);

}  // namespace pcm::simbody
