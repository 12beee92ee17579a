// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/pose_path.h"

#include <Eigen/Geometry>

#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

/// R(phi): the rotation by |phi| about phi.
Eigen::Matrix3d rotation(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  if (!(angle > 0)) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, phi / angle).toRotationMatrix();
}

/// phi of a rotation, |phi| <= pi.
Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(Eigen::Quaterniond(R).normalized());
  return turn.angle() * turn.axis();
}

}  // namespace

PathSegment::PathSegment(const Pose& from, const Pose& to) : from_(from), to_(to) {
  if (from.A == to.A) return;
  turn_Me_ = rotation_vector(to.A * from.A.transpose());
  drift_ = rotation(turn_Me_).transpose() * to.A - from.A;
}

Pose PathSegment::at(double share) const {
  if (share == 0) return from_;
  if (share == 1) return to_;
  Pose pose;
  pose.r = from_.r + share * shift_Me();
  pose.A = from_.A == to_.A ? from_.A : Eigen::Matrix3d(rotation(share * turn_Me_) * (from_.A + share * drift_));
  return pose;
}

PosePath::PosePath(const std::vector<Pose>& poses) {
  if (poses.size() < 2) throw BadInput("a path needs at least two poses");
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const PathSegment& segment = segments_.emplace_back(poses[i], poses[i + 1]);
    length_ += segment.shift_Me().norm();
    turn_ += segment.turn_Me().norm();
  }
  closed_ = poses.front().A == poses.back().A && poses.front().r == poses.back().r;
}

}  // namespace pcm::compare
