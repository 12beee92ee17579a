// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "pcm/engine.h"
#include "pcm/inputs.h"

namespace pcm::simbody {

/// What a pairing does: force on E's body, N, then torque on it about Mf, N m, both in Me.
/// Of no alignment of its own, as fast::Tangent.
using Load = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;

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
  fast::Tangent slope = fast::Tangent::Zero();

  /// The load by the tangent. For a rotation by phi, a is taken sin(phi) long, which is off by at most phi^3 / 6.
  Load at(const Pose& to, const Velocity& at_velocity) const;
};

/// By one evaluation of the engine, whose derivatives these are (Wanted::tangent): where it says that they are of one
/// side, or that the force jumps, so it is here. Throws as fast::evaluate does.
LoadTangent load_tangent(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                         fast::Workspace& workspace);

}  // namespace pcm::simbody
