// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/published/triangle_segment.h"

namespace pcm::compare::published {

/// The paper's "well-tried value" of the snap distance (3.2, step 1), m: end points nearer than this are one. So small
/// that only end points with the same bits are.
inline constexpr double kSnapDistance = 1e-20;

/// Some intersection lines in a row, `count` of them from `first` on, in the circulation of (5).
struct SegmentChain {
  bool closed = false;
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Step 1: sorts the intersection lines into polygons, by the distances of their end points. Starting from any line,
/// the next one is the first of the remaining ones with an end nearer than the snap distance to the free end, until
/// there is none; then the same at the other free end. The circulation (5) of a polygon is that of its longest line.
/// O(n^2) distances, as published.
void chain_segments(std::vector<Segment>& segments, std::vector<SegmentChain>& chains);

}  // namespace pcm::compare::published
