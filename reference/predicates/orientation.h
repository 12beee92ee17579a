// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reference/pose/exact_pose.h"

namespace pcm::reference {

/// A face moved by -s times its doubled normal, s -> 0+, before the tie rule applies: what lies just inside its body.
struct ShiftedFace {
  Side side = Side::E;
  Index face = 0;
};

/// A number times det[b - a, c - a, d - a] of four vertices (a, b, c, d).
struct WeightedDeterminant {
  Exact weight;
  std::array<Vertex, 4> vertices;
};

/// The one predicate on which crossings, polygons and active areas hang: on which side of a plane a vertex lies.
///
/// Stages: intervals, then exact numbers, then the tie rule (simulation of simplicity, Edelsbrunner and Muecke 1990,
/// DESIGN section 2): coordinate
/// j = 1, 2, 3 of vertex i is moved by eps^(2^(3 i - j)), i counting E's vertices from 1 in file order, then F's. The
/// perturbed determinant is a polynomial in eps; the sign of its first non-zero coefficient is the answer. What holds
/// of orient3d: (1) it is never 0; (2) exchanging two of the points, with their numbers, negates it; (3) only the order
/// of the numbers matters. Points that coincide, lie on a line or in a plane are welcome. Not promised: the same sign
/// of a tie after moving or turning both bodies, reordering vertices, or exchanging E and F.
class Orientation {
 public:
  /// The pose must outlive this.
  explicit Orientation(const ExactPose& pose, std::optional<ShiftedFace> shifted = {})
      : pose_(pose), shifted_(shifted) {}

  const ExactPose& pose() const { return pose_; }

  /// Sign of det[b - a, c - a, d - a], perturbed: +1 where d lies on the side of (a, b, c) its normal points to.
  int orient3d(Vertex a, Vertex b, Vertex c, Vertex d) const;

  /// +1 where x is above the face (on the side of its outward normal), -1 below.
  int side(Vertex x, Side face_side, Index face) const;

  /// Sign of the perturbed det[b - a, c - a] of the projections on the x-y plane: +1 counterclockwise seen from +z.
  int orient_xy(Vertex a, Vertex b, Vertex c) const;

  /// Sign of a sum of determinants, perturbed. A determinant is linear in each of its points; so this is the sign of
  /// one that has a point with barycentric coordinates in a face, as its weights, in the place of a vertex, and that
  /// moves with the face. 0 only where the sum is without any term, however perturbed.
  int sign_of_sum(const std::vector<WeightedDeterminant>& sum) const;

  /// Sign of the same determinant as orient3d, before any perturbation: 0 where the four points are coplanar.
  int exact_orientation(Vertex a, Vertex b, Vertex c, Vertex d) const;

 private:
  template <int D>
  int tie_rule(const std::array<Vertex, D + 1>& vertices) const;
  template <int D>
  auto rows_of(const std::array<Vertex, D + 1>& vertices) const;
  bool is_shifted(Vertex v) const;

  const ExactPose& pose_;
  std::optional<ShiftedFace> shifted_;
};

/// Sign of det[b - a, c - a, d - a] for all points within the boxes; 0 where it is not the same for all.
int certain_orientation(const Box& a, const Box& b, const Box& c, const Box& d);

/// One term of the perturbed determinant of D + 1 points in D dimensions: which point (by rank, 0 first) is replaced by
/// which coordinate's unit vector, -1 where by none.
template <int D>
using PerturbationTerm = std::array<int, D + 1>;

/// All terms, by ascending power of eps, the unperturbed determinant first.
template <int D>
const std::vector<PerturbationTerm<D>>& perturbation_terms();

}  // namespace pcm::reference
