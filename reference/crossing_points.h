// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "reference/crossings.h"
#include "reference/lifted_pose.h"

namespace pcm::reference {

/// Where crossings lie. Regular: the edge meets the face's plane. Degenerate (both ends of the edge in the plane,
/// before the tie rule): the midpoint of closed edge and closed face, kept as exact numbers; no area depends on that
/// choice.
class CrossingPoints {
 public:
  CrossingPoints(const ExactPose& pose, std::vector<CrossingId> ids);

  const std::vector<CrossingId>& ids() const { return ids_; }

  /// Number kinds with division: Rational, Ball, DoubleDouble.
  template <class T>
  Vec3<T> position(Index crossing, LiftedPose<T>& pose) const {
    if (const auto& midpoint = midpoints_[crossing])
      return {pose.number(midpoint->x), pose.number(midpoint->y), pose.number(midpoint->z)};
    const CrossingId& id = ids_[crossing];
    const Vec3<T>& a = pose.point({id.edge_side, id.edge[0]});
    const Vec3<T>& b = pose.point({id.edge_side, id.edge[1]});
    const auto [p, q, s] = pose.corners(other(id.edge_side), id.face);
    const Vec3<T> normal = doubled_normal(p, q, s);
    const T t = dot(normal, a - p) / dot(normal, a - b);
    return a + t * (b - a);
  }

 private:
  std::vector<CrossingId> ids_;
  std::vector<std::optional<Vec3<Rational>>> midpoints_;
};

}  // namespace pcm::reference
