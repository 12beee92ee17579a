// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/load_tangent.h"

#include "simbody/load_of_contact.h"

namespace pcm::simbody {
namespace {

/// Along r, the rotation vector, v, w.
using Displacement = Eigen::Matrix<double, 12, 1>;

struct Motion {
  Pose pose;
  Velocity velocity;
};

/// Axis times the sine of the angle.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R) {
  return 0.5 * Eigen::Vector3d(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
}

Displacement displacement(const Motion& from, const Motion& to) {
  Displacement d;
  d << to.pose.r - from.pose.r, rotation_vector(to.pose.A * from.pose.A.transpose()), to.velocity.v - from.velocity.v,
      to.velocity.w - from.velocity.w;
  return d;
}

}  // namespace

Load LoadTangent::at(const Pose& to, const Velocity& at_velocity) const {
  return load + slope * displacement({pose, velocity}, {to, at_velocity});
}

LoadTangent load_tangent(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                         fast::Workspace& workspace) {
  Wanted wanted = kLoadAlone;
  wanted.tangent = true;
  const fast::Contact& contact = fast::evaluate(pairing, pose, velocity, wanted, workspace);
  return {pose, velocity, load_of(contact), *contact.tangent};
}

}  // namespace pcm::simbody
