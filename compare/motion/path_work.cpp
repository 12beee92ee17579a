// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/motion/path_work.h"

#include <algorithm>
#include <cmath>

namespace pcm::compare {
namespace {

/// Trapezoidal rule between two places of one segment.
double work_between(const PosePath& path, const PathForcePoint& a, const PathForcePoint& b) {
  const double share = b.where.share() - a.where.share();
  const Eigen::Vector3d turn = share * path.segments()[a.where.segment].turn_Me();
  return -((a.force_Me + b.force_Me).dot(b.r_Me - a.r_Me) + (a.torque_Me + b.torque_Me).dot(turn)) / 2;
}

}  // namespace

PathWork path_work(const PosePath& path, const PathWalk& walk) {
  PathWork sum;
  double coarse = 0;
  const std::vector<PathForcePoint>& points = walk.points;
  std::size_t last = 0;  // of the places that are not left out
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PathForcePoint& point = points[i];
    sum.greatest_torque = std::max(sum.greatest_torque, point.torque_Me.stableNorm());
    if (const double force = point.force_Me.stableNorm(); force > sum.greatest_force) {
      sum.greatest_force = force;
      sum.greatest_force_at = point.where;
    }
    // Segments share their ends, where the first one's last place and the second one's first are the same pose.
    if (i == 0 || points[i - 1].where.segment != point.where.segment) {
      last = i;
      continue;
    }
    sum.work += work_between(path, points[i - 1], point);
    const bool ends_here = i + 1 == points.size() || points[i + 1].where.segment != point.where.segment;
    const bool keep = point.after_jump || ends_here || points[i + 1].after_jump || i - last == 2;
    if (!keep) continue;
    coarse += work_between(path, points[last], point);
    last = i;
  }
  sum.error = std::abs(sum.work - coarse) / 3;
  sum.greatest = sum.greatest_force * path.length() + sum.greatest_torque * path.turn();
  return sum;
}

TangentialForce tangential_force(const PathWalk& walk, const Eigen::Vector3d& normal_Me) {
  const Eigen::Vector3d n = normal_Me.stableNormalized();
  TangentialForce found;
  bool none = true;
  for (const PathForcePoint& point : walk.points) {
    if (!point.step) continue;
    const double along = point.force_Me.dot(n);
    const double within = (point.force_Me - along * n).stableNorm();
    found.greatest_normal = std::max(found.greatest_normal, std::abs(along));
    if (none || within > found.greatest) {
      none = false;
      found.greatest = within;
      found.normal_there = std::abs(along);
      found.at = point.where;
    }
  }
  return found;
}

}  // namespace pcm::compare
