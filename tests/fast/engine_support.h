// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <utility>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"
#include "tests/meshes/transformed_meshes.h"
#include "tests/shifted_pose.h"

/// What the tests of the engine share: short names for poses and one-off evaluations.
namespace pcm::fast::test {

/// A rotation that no coordinate plane survives, about an axis in general position.
inline Pose turned(double angle, const Eigen::Vector3d& r) {
  Pose pose;
  pose.A = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.r = r;
  return pose;
}

inline ContactLaw stiffness(double c_l) {
  ContactLaw law;
  law.stiffness = c_l;
  return law;
}

/// With damping d_l, N s/m^3, its fade and friction: all that depends on velocities.
inline ContactLaw rough(double damping) {
  ContactLaw law = stiffness(5.9e5);
  law.damping = damping;
  law.transition_depth = 0.01;
  law.friction = 0.25;
  law.slip_velocity = 0.5;
  return law;
}

inline constexpr Wanted kTangent{.polygons = false, .areas = false, .force = true, .elements = false, .tangent = true};

/// A copy of the answer to one question.
inline Contact answer(const TriangleMesh& E, const TriangleMesh& F, const Pose& pose = {},
                      const ContactLaw& law = stiffness(1), Mode mode = Mode::E, const Velocity& velocity = {},
                      const Wanted& wanted = {}, Scheme scheme = Scheme::barycentric) {
  Workspace workspace;
  return evaluate(Pairing(Surface(E), Surface(F), law, mode, scheme), pose, velocity, wanted, workspace);
}

}  // namespace pcm::fast::test
