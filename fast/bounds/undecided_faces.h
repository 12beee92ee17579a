// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fast/active/intersection.h"

namespace pcm::fast {

/// The faces of a master that may be active in the exact problem and not in the rounded one, or the reverse (PCM
/// sections 1 and 5).
struct UndecidedFaces {
  std::vector<Index> faces;
  FastClearArray<bool> is_undecided;    ///< by face
  FastClearArray<bool> surely_crossed;  ///< by face: scratch
};

/// Finds them. The candidate pairs must have been kept; `rounding_Me` bounds the rounding of F's vertices, component by
/// component.
///
/// Candidate pairs hold every pair of faces that touch for any position of F's vertices between both problems.
/// Closed slave: a face stays intersected where one of its pairs surely crosses. A face all of whose pairs surely stay
/// apart stays inner or stays outside: its vertices' winding numbers change only where the slave touches it. Any other
/// one is undecided.
/// Open slave: labels come from all crossings at once, so where any pair is not sure, all faces are undecided.
/// May be too careful, never too bold. Cost: near 50 operations for a pair that is not part of the crossings.
void find_undecided_faces(const Intersection& intersection, Side master, const Eigen::Vector3d& rounding_Me,
                          UndecidedFaces& undecided);

}  // namespace pcm::fast
