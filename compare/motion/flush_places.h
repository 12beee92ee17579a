// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/motion/pose_path.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// A share of a segment, and how far off it rounding may have put it.
struct FlushPlace {
  double share = 0;
  double error = 0;
};

struct FlushPlaces {
  std::vector<FlushPlace> places;  ///< ascending, near ones merged
  bool all_along = false;          ///< some pair stays flush, as near as rounding tells, wherever it comes to overlap
};

/// Where on a segment a face of E and a face of F with the same normal come to lie in one plane: the only poses at
/// which the clipped scheme's elastic force may jump (PCM section 6). The motion n_F(s) = R(s phi) A n_F keeps the
/// component along phi, so a pair of faces is parallel all along (their distance is then linear in s), at one s, or
/// never. Whether the faces overlap is not asked. O(n log n + pairs found) in the number
/// of distinct planes.
FlushPlaces flush_places(const TriangleMesh& E, const TriangleMesh& F, const PathSegment& segment);

}  // namespace pcm::compare
