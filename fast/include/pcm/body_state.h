// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "pcm/inputs.h"

/// Bodies of a scene: where they are, and what their contacts do to them.
namespace pcm::fast {

/// Where a body is and how it moves, resolved in the scene's frame W: x_W = A x + r for points x of its surface, v =
/// dr/dt, w its angular velocity.
struct BodyState {
  Pose pose;
  Velocity velocity;
};

/// What a pairing contributes, at the marker of its body F, in the frame of its body E; all zero where it is apart.
struct PairingLoad {
  bool touching = false;
  bool nested = false;                                  ///< not known where the pairing wants only touch
  Eigen::Vector3d force_Me = Eigen::Vector3d::Zero();   ///< on body E, N
  Eigen::Vector3d torque_Me = Eigen::Vector3d::Zero();  ///< on body E about Mf, N m
};

/// Force and torque on a body, torque about its own origin, in W.
struct BodyLoad {
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d torque_W = Eigen::Vector3d::Zero();  ///< N m
};

}  // namespace pcm::fast
