// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "fast/active/active_areas.h"
#include "fast/crossings/polygons.h"

namespace pcm::fast {

/// Which polygons bound one contact patch.
struct Patches {
  std::vector<Index> of_polygon;  ///< from 0
  Index count = 0;
};

/// Scratch memory of group_patches.
struct PatchScratch {
  std::array<FastClearArray<Index>, 2> region;  ///< by vertex: inside vertices joined by uncrossed edges share one
  std::vector<Index> parents;                   ///< disjoint sets of polygons and of regions
  std::vector<Index> patch_of_set;
  std::vector<Index> stack;
};

/// Groups the polygons to patches: polygons reached by one flood belong together. A flood runs over vertices inside the
/// other body along uncrossed edges; an edge with one crossing joins its inside end to that polygon; an edge with two
/// crossings and both ends outside joins their polygons. Numbered by their first polygon. The crossings must be listed
/// by edge.
void group_patches(const PosedPair& posed, const Crossings& crossings, const PolygonChains& chains,
                   const ActiveAreas& areas, PatchScratch& scratch, Patches& patches);

}  // namespace pcm::fast
