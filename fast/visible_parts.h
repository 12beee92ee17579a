// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fast/projected_face.h"

namespace pcm::fast {

/// A face in the prism together with its vertices in Me.
struct PlacedFace {
  const ProjectedFace& projected;
  std::array<Eigen::Vector3d, 3> points_Me;  ///< of `projected.vertices`, so counterclockwise as the master sees them
};

/// Takes from `parts` of the face f, through which the lines leave the slave, what they reach only after g: where g is
/// met at a depth >= 0 and not farther than f (PCM section 6). Where the two planes are one, the face of smaller index
/// is before the other one of the slave, and none of the master is before any of the slave. Which of two faces lies
/// before the other is decided exactly where the plane of one has the other on one side, as it has wherever faces
/// share a vertex and wherever they do not intersect; the part taken is exact but for roundings. `remaining` is
/// scratch.
void subtract_hidden(const MasterPrism& prism, const PlacedFace& f, const PlacedFace& g,
                     std::vector<ConvexPolygon>& parts, std::vector<ConvexPolygon>& remaining, WorkCounters& work);

}  // namespace pcm::fast
