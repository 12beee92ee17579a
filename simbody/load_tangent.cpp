// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcm/load_tangent.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "pcm/pairing_memory.h"
#include "simbody/load_of_contact.h"

namespace pcm::simbody {
namespace {

/// Along r, the rotation vector, v, w.
using Displacement = Eigen::Matrix<double, 12, 1>;
constexpr int kCoordinates = 12, kOfPose = 6;

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

Motion displaced(Motion motion, int coordinate, double change) {
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(coordinate % 3);
  switch (coordinate / 3) {
    case 0:
      motion.pose.r += change * axis;
      break;
    case 1:
      motion.pose.A = Eigen::AngleAxisd(change, axis).toRotationMatrix() * motion.pose.A;
      break;
    case 2:
      motion.velocity.v += change * axis;
      break;
    default:
      motion.velocity.w += change * axis;
  }
  return motion;
}

double increment(int coordinate, const Motion& at, const TangentIncrements& increments) {
  const double root_of_eps = std::sqrt(std::numeric_limits<double>::epsilon());
  switch (coordinate / 3) {
    case 0:
      return std::max(increments.length, root_of_eps * at.pose.r.norm());
    case 1:
      return std::max(increments.angle, root_of_eps);
    case 2:
      return std::max(increments.speed, root_of_eps * at.velocity.v.norm());
    default:
      return std::max(increments.angular_speed, root_of_eps * at.velocity.w.norm());
  }
}

bool is_of_use(const fast::Contact& contact) {
  return !contact.nested && !contact.penetration_exceeded;
}

/// The engine, counted, with a memory for the pose that velocities share.
class Asked {
 public:
  Asked(const fast::Pairing& pairing, fast::Workspace& workspace, TangentAnswer& count)
      : pairing_(pairing), workspace_(workspace), count_(count), memory_(pairing) {}

  const fast::Contact& about(const Motion& motion, int coordinate) {
    const fast::Contact& contact = coordinate < kOfPose
                                       ? fast::evaluate(pairing_, motion.pose, motion.velocity, kLoadAlone, workspace_)
                                       : memory_.evaluate(motion.pose, motion.velocity, kLoadAlone, workspace_);
    ++(contact.work.law_only != 0 ? count_.law_only : count_.whole);
    return contact;
  }

 private:
  const fast::Pairing& pairing_;
  fast::Workspace& workspace_;
  TangentAnswer& count_;
  fast::PairingMemory memory_;
};

}  // namespace

Load LoadTangent::at(const Pose& to, const Velocity& at_velocity) const {
  return load + slope * displacement({pose, velocity}, {to, at_velocity});
}

TangentAnswer load_tangent(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity, const Load& load,
                           const TangentIncrements& increments, fast::Workspace& workspace) {
  TangentAnswer answer;
  answer.tangent = {pose, velocity, load};
  const Motion here{pose, velocity};
  Asked asked(pairing, workspace, answer);
  for (int coordinate = 0; coordinate < kCoordinates; ++coordinate) {
    const double change = increment(coordinate, here, increments);
    Motion there = displaced(here, coordinate, change);
    const fast::Contact* contact = &asked.about(there, coordinate);
    if (!is_of_use(*contact)) {
      there = displaced(here, coordinate, -change);
      contact = &asked.about(there, coordinate);
    }
    answer.exists = is_of_use(*contact);
    if (!answer.exists) return answer;
    // Over the distance that rounding has left of the change.
    answer.tangent.slope.col(coordinate) = (load_of(*contact) - load) / displacement(here, there)[coordinate];
  }
  return answer;
}

}  // namespace pcm::simbody
