// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "fast/prism/convex_polygon.h"
#include "fast/prism/master_prism.h"
#include "pcm/triangle_mesh.h"

namespace pcm::fast {

/// The corners of a face as a master face sees them.
struct SeenCorners {
  std::array<PrismPoint, 3> points;
  std::array<bool, 3> is_shared{};  ///< which of them are the master face's own, seen exactly
};

/// A face of the slave, or another one of the master, as the penetration lines of a master face meet it.
struct ProjectedFace {
  Index face;
  bool of_master;  ///< a face of the master
  bool leaves;     ///< the lines leave that face's body there, N . N_f < 0
  bool carries;    ///< may carry an element: a face of the slave that certainly is left there, over an area
  std::array<Index, 3> vertices;
  std::array<PrismPoint, 3> corners;  ///< of `vertices`, counterclockwise in (s, t)
  ConvexPolygon seen;                 ///< the part over the master face at a depth >= 0, whatever lies before it
  double low_s, high_s, low_t, high_t;
  Uncertainty uncertainty;  ///< of its sides

  ProjectedFace() {}
};

/// Projects a face with the given vertices, seen by the prism at `corners`. False where no line meets it: seen
/// edgewise, beside the master face or above it.
bool project_face(const std::array<Index, 3>& vertices, const std::array<PrismPoint, 3>& corners, ProjectedFace& face);

/// Where a face overlaps another one: a face that leaves the slave, and one that may lie before it.
using Overlap = std::pair<std::size_t, std::size_t>;

/// Finds all overlaps among the faces of positive area, ordered by first, then second; the first is always a face of
/// the slave through which it is left. `order` is scratch. Sweeps along s: O(n log n) plus the pairs that overlap
/// there.
void find_overlaps(const std::vector<ProjectedFace>& faces, std::vector<std::size_t>& order,
                   std::vector<Overlap>& overlaps);

}  // namespace pcm::fast
