// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/workspace.h"

namespace pcm::fast {

/// Chains the segments to polygons by identity (PCM section 4): fills `polygons`, `crossing_order` and the crossings'
/// `polygon`. Canonical order: crossings are compared by (side, edge, face); a closed polygon starts at its smallest
/// crossing, an open one where the circulation of (5) starts; polygons are sorted by their first crossing. Linear but
/// for the sort of the polygons.
void chain_polygons(Workspace::Data& workspace);

/// Groups the polygons to patches: polygons reached by one flood belong together. A flood runs over vertices inside the
/// other body along uncrossed edges; an edge with one crossing joins its inside end to that polygon; an edge with two
/// crossings and both ends outside joins their polygons. Numbered by their first polygon.
/// Needs the active areas and `edge_crossings`.
void group_patches(Workspace::Data& workspace);

}  // namespace pcm::fast
