// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/published/intersection_polygons.h"
#include "fast/base/fast_clear_array.h"

namespace pcm::compare::published {

/// Step 2 for one surface: which of its faces are active. Scratch memory, grown once.
class ActiveFaces {
 public:
  /// The inner vertices of edges that a polygon crosses, by a relation like (5), and whatever can be reached from them
  /// along edges that none crosses; faces at such vertices are inner unless intersected. An edge with several crossings
  /// has each end told by the crossing next to it. Polygons that bound the same active area get the same number in
  /// `patch_of`, a forest of polygons that grows by both surfaces in turn.
  void find(const Surface& surface, Side side, const std::vector<Segment>& segments,
            const std::vector<SegmentChain>& chains, std::vector<Index>& patch_of);

  const std::vector<Index>& intersected() const { return intersected_; }  ///< ascending
  const std::vector<Index>& inner() const { return inner_; }              ///< ascending
  const std::vector<Index>& active() const { return active_; }            ///< both, ascending

 private:
  /// The crossings of an edge next to its two ends.
  struct CrossedEdge {
    double along_first = 2, along_second = -1;
    bool first_inside = false, second_inside = false;
    Index chain = -1;
  };

  void note_crossings(const Surface& surface, Side side, const std::vector<Segment>& segments,
                      const std::vector<SegmentChain>& chains, std::vector<Index>& patch_of);
  void reach(Index vertex, Index chain, std::vector<Index>& patch_of);
  void flood(const Surface& surface, std::vector<Index>& patch_of);
  void list_faces(const Surface& surface);

  fast::FastClearArray<CrossedEdge> crossed_;
  fast::FastClearArray<Index> chain_of_vertex_;  ///< of inner vertices
  fast::FastClearArray<bool> seen_faces_;
  std::vector<Index> crossed_edges_, inner_vertices_, intersected_, inner_, active_;
};

/// The smallest number in a polygon's tree, by which its patch goes.
Index root_of(std::vector<Index>& patch_of, Index chain);

}  // namespace pcm::compare::published
