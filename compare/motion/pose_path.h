// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pcm/inputs.h"

namespace pcm::compare {

/// Places on a path are whole multiples of 2^-52 of a segment: what two neighbouring ones enclose can't be told apart.
inline constexpr std::int64_t kGrid = std::int64_t{1} << 52;

/// A place on a path: between pose `segment` and the next, at the share s = tick / kGrid, 0 <= tick <= kGrid.
struct PathPoint {
  std::size_t segment = 0;
  std::int64_t tick = 0;

  double share() const { return static_cast<double>(tick) / static_cast<double>(kGrid); }
  /// Number of the pose, from 0, plus the share of the way to the next.
  double position() const { return static_cast<double>(segment) + share(); }
};

/// The rigid motion between two poses: r moves on a straight line while F turns by the angle |phi| <= pi about a fixed
/// axis through Mf, both at constant speed. A(s) = R(s phi) (A_0 + s (R(phi)^T A_1 - A_0)): the last factor hands over
/// from one matrix to the other where they are rotations but for roundings. At s = 0 it is the first pose, at s = 1
/// the second, bit for bit.
class PathSegment {
 public:
  PathSegment(const Pose& from, const Pose& to);

  Pose at(double share) const;

  Eigen::Vector3d shift_Me() const { return to_.r - from_.r; }  ///< m
  const Eigen::Vector3d& turn_Me() const { return turn_Me_; }   ///< phi, rad; null where A is the same, bit for bit

 private:
  Pose from_, to_;
  Eigen::Vector3d turn_Me_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d drift_ = Eigen::Matrix3d::Zero();  ///< R(phi)^T A_1 - A_0
};

/// Poses and the rigid motions that join each to the next.
class PosePath {
 public:
  /// Throws BadInput for fewer than two poses.
  explicit PosePath(const std::vector<Pose>& poses);

  const std::vector<PathSegment>& segments() const { return segments_; }
  Pose at(const PathPoint& point) const { return segments_[point.segment].at(point.share()); }
  bool closed() const { return closed_; }    ///< the last pose is the first, bit for bit
  double length() const { return length_; }  ///< of the way of Mf, m
  double turn() const { return turn_; }      ///< sum of the angles, rad

 private:
  std::vector<PathSegment> segments_;
  bool closed_ = false;
  double length_ = 0;
  double turn_ = 0;
};

}  // namespace pcm::compare
