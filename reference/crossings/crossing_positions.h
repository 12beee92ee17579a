// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "reference/crossings/crossings.h"
#include "reference/pose/converted_pose.h"

namespace pcm::reference {

/// Where crossings lie: the edge meets the face's plane.
///
/// That is one point, and where the perturbed crossing tends to as the tie rule's eps -> 0: no edge crosses a face in
/// whose plane it lies, nor a face without area, which is no more than a segment. For let x be a point of E's feature,
/// with weights w_i at its vertices i, and y one of F's, with any weights. Before the perturbation both features lie in
/// one plane with a normal n (else a segment and an edge stay apart), so x - y moves along n by
///   sum_i w_i n . d_i  -  the same of F,   n . d_i = n_j eps^(2^(3 i - j)) (1 + o(1)),   j the last with n_j != 0.
/// All terms of E have one sign. As some w_i >= 1/3, their sum is at least |n_j| eps^(2^(3 i - j)) / 4 for the last
/// vertex i of E, and what any vertex of F moves by is of smaller order. So x - y is not 0. (And so PCM section 4's
/// midpoint is for no crossing.)
class CrossingPositions {
 public:
  explicit CrossingPositions(std::vector<CrossingId> ids) : ids_(std::move(ids)) {}

  const std::vector<CrossingId>& ids() const { return ids_; }

  /// Number kinds with division: Rational, Ball, DoubleDouble.
  template <class T>
  Vec3<T> position(Index crossing, ConvertedPose<T>& pose) const {
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
};

}  // namespace pcm::reference
