// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/crossings/candidates.h"
#include "reference/predicates/orientation.h"

namespace pcm::reference {

/// A face of E and a face of F in one plane, before any perturbation, with a common part of positive area.
struct CoplanarOverlap {
  Index face_E = 0;
  Index face_F = 0;
  bool equal_normals = false;           ///< otherwise opposite
  std::vector<Vec3<Rational>> polygon;  ///< the common part, counterclockwise seen from outside E; exact
  Rational share_E = 0;                 ///< its area in units of the doubled normal's length of face_E, > 0
  Rational share_F = 0;                 ///< the same for face_F
  bool E_above_F = false;               ///< the tie rule moves the part of face_E to the outer side of face_F

  const Rational& share(Side side) const { return side == Side::E ? share_E : share_F; }

  /// Whether the tie rule moves this part of the side's face to the inner side of the other face. Faces with opposite
  /// normals are both moved inside or both outside; of faces with equal normals one is.
  bool inside(Side side) const { return (side == Side::F && equal_normals) == E_above_F; }
};

/// All such pairs among the candidates. Exact.
///
/// Where the tie rule moves them (PCM section 4): E away from F along face_F's normal N by a number with the sign of
/// the first non-zero of N_z, N_y, N_x, all of the common part to one side (the proof is in crossing_positions.h).
std::vector<CoplanarOverlap> find_coplanar_overlaps(const ExactPose& pose, const std::vector<IndexPair>& candidates);

}  // namespace pcm::reference
