// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "reference/crossings.h"

namespace pcm::reference {

/// Where crossings lie. Regular: the edge meets the face's plane. Degenerate (both ends of the edge in the plane,
/// before the tie rule): the midpoint of closed edge and closed face, kept as exact numbers; no area depends on that
/// choice.
class CrossingPoints {
 public:
  /// The pose must outlive this.
  CrossingPoints(const ExactPose& pose, std::vector<CrossingId> ids);

  const std::vector<CrossingId>& ids() const { return ids_; }

  /// Number kinds with division: Rational, Ball.
  template <class T>
  Vec3<T> position(Index crossing, const Field<T>& field = {}) const {
    if (const auto& midpoint = midpoints_[crossing])
      return {field(midpoint->x), field(midpoint->y), field(midpoint->z)};
    const CrossingId& id = ids_[crossing];
    const Vec3<T> a = pose_.point<T>({id.edge_side, id.edge[0]}, field);
    const Vec3<T> b = pose_.point<T>({id.edge_side, id.edge[1]}, field);
    const auto [p, q, s] = pose_.corners<T>(other(id.edge_side), id.face, field);
    const Vec3<T> normal = doubled_normal(p, q, s);
    const T height_a = dot(normal, a - p);
    const T t = height_a / dot(normal, a - b);
    return a + t * (b - a);
  }

 private:
  const ExactPose& pose_;
  std::vector<CrossingId> ids_;
  std::vector<std::optional<Vec3<Rational>>> midpoints_;
};

}  // namespace pcm::reference
