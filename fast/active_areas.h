// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/workspace.h"

namespace pcm::fast {

/// Finds the active area of one side (PCM section 5): fills `inner` (ascending) and the winding numbers or labels; sets
/// the answer's `nested` and `ambiguous`. Exact on the rounded problem.
/// Closed other surface: one vertex of each part that the crossings leave undecided is located directly, winding
/// numbers spread from there over the intersected faces' edges and over the inside, never over the outside; a component
/// without crossing is located by one vertex. Cost near the size of the active area, in memory that has grown.
/// Open other surface: labels come from crossed edges alone and spread over sets of uncrossed faces, rule by rule as
/// in PCM section 5; nothing is nested. Cost up to the size of the components touched.
/// Needs `edge_crossings` and `intersected` of that side.
void find_active_area(Workspace::Data& workspace, Side side);

/// The part for a closed and for an open other surface.
void find_active_area_in_closed(Workspace::Data& workspace, Side side);
void find_active_area_in_open(Workspace::Data& workspace, Side side);

/// Change of the other surface's winding number along edge k of a face, from its vertex k on.
inline Index winding_change_along(const SideState& side, Index face, std::size_t k) {
  const Index change = side.edge_crossings.get(side.surface().edges_of(face)[k], {}).winding_change;
  return side.surface().runs_forwards(face, k) ? change : -change;
}

/// Computes the clipped active areas and the volume between them into the answer (PCM section 5). Needs the polygons
/// with positions and both active areas. Area and vector area of a face are exact but for roundings of a few ulps of
/// the lengths of its patch's edges times the face's size.
void measure_clipped_areas(Workspace::Data& workspace);

}  // namespace pcm::fast
