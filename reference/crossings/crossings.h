// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <vector>

#include "reference/crossings/candidates.h"
#include "reference/predicates/orientation.h"

namespace pcm::reference {

/// An edge of one surface passes through a face of the other (PCM section 4). Ordered as polygons order them.
struct CrossingId {
  Side edge_side = Side::E;
  std::array<Index, 2> edge{};  ///< smaller vertex index first
  Index face = 0;
  auto operator<=>(const CrossingId&) const = default;
};

/// What a crossing pair (e, f) has in common: from one crossing to another in the circulation of (5), the part of E
/// inside F on the left seen from outside E. `start` and `end` count in Crossings::ids.
struct Segment {
  Index face_E = 0;
  Index face_F = 0;
  Index start = kNone;
  Index end = kNone;
};

struct Crossings {
  std::vector<CrossingId> ids;    ///< ascending, each once
  std::vector<int> deltas;        ///< +1 where edge[0] lies above the face (so edge[1] is one deeper inside), else -1
  std::vector<Segment> segments;  ///< one a crossing pair, ascending by (e, f)
};

/// A crossing of one face pair with the part it plays in the pair's segment.
struct PairCrossing {
  CrossingId id;
  int delta = 0;        ///< along id.edge
  bool starts = false;  ///< the segment; otherwise it ends it
};

/// The crossings of the face pair (e, f): none, or one that starts the segment and one that ends it.
std::vector<PairCrossing> pair_crossings(const Orientation& orientation, Index e, Index f);

/// All crossings among the candidate pairs.
Crossings find_crossings(const Orientation& orientation, const std::vector<IndexPair>& candidates);

}  // namespace pcm::reference
