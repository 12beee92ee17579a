// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "fast/base/fast_clear_array.h"
#include "fast/base/shares.h"
#include "fast/crossings/pair_signs.h"
#include "fast/crossings/tracked_pairs.h"
#include "fast/posed/posed_team.h"
#include "fast/search/candidates.h"

namespace pcm::fast {

/// A crossing while its polygon is being made. The segment that starts at it runs through the crossing pair
/// (segment_face[E], segment_face[F]) to the crossing `next`.
struct CrossingNode {
  Side edge_side = Side::E;
  Index edge = 0;           ///< index among the edges of its surface
  Index face = 0;           ///< of the other surface
  bool from_above = false;  ///< the edge's first vertex is above the face: the winding number grows along the edge
  bool has_previous = false;
  Index next = -1;  ///< -1 where an open polygon ends
  std::array<Index, 2> segment_face{-1, -1};
  Index polygon = -1;
  Index next_on_edge = -1;  ///< another crossing of the same edge, in the polygons' order
  Eigen::Vector3d position_Me = Eigen::Vector3d::Zero();

  /// E before F, then by the edge's vertices, then by face; edges are numbered in the order of their vertices.
  std::uint64_t key() const {
    return (static_cast<std::uint64_t>(edge_side) << 63) | (static_cast<std::uint64_t>(edge) << 31) |
           static_cast<std::uint64_t>(face);
  }
  /// Change of the winding number of the face's surface along the edge, from its smaller to its greater vertex.
  int winding_change() const { return from_above ? 1 : -1; }
};

/// The crossings of one edge.
struct EdgeCrossings {
  Index first = -1;  ///< in Crossings::nodes; the others follow by next_on_edge
  Index count = 0;
  Index winding_change = 0;  ///< sum over them, from the smaller vertex to the greater
};

/// What is crossed of one surface.
struct CrossedSurface {
  std::vector<Index> intersected;       ///< faces in a crossing pair, ascending
  FastClearArray<bool> is_intersected;  ///< by face
  FastClearArray<EdgeCrossings> edges;  ///< by edge, where there is one; by list_crossings_by_edge
};

/// All crossings of a pose, with the segments between them.
struct Crossings {
  /// In the order in which they were found, which is nobody's where several threads searched: polygons are in an order
  /// of their own.
  std::vector<CrossingNode> nodes;
  std::array<CrossedSurface, 2> surfaces;
  /// Face pairs (E, F) that may touch, in the order of the search: where they are to be kept.
  std::vector<std::pair<Index, Index>> candidates;

  CrossedSurface& of(Side side) { return surfaces[static_cast<std::size_t>(side)]; }
  const CrossedSurface& of(Side side) const { return surfaces[static_cast<std::size_t>(side)]; }
  const CrossingNode& operator[](Index crossing) const { return nodes[static_cast<std::size_t>(crossing)]; }
};

/// Crossings by key: open addressing, emptied in constant time.
class CrossingIndex {
 public:
  /// Where a key is looked for first, of 2^log2_places > 1 places: the highest bits of a product, for each depends on
  /// all bits of the key that are no higher. Keys of one face and many edges differ in high ones alone.
  static std::size_t first_place(std::uint64_t key, int log2_places) {
    return static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> (64 - log2_places));
  }

  void start();
  /// The place of the crossing with this key in the list; where it is new, `fresh` is entered and returned, which must
  /// be the number of keys so far.
  Index find_or_insert(std::uint64_t key, Index fresh);

 private:
  struct Slot {
    std::uint64_t key = 0;
    Index value = -1;
  };
  std::size_t places() const { return std::size_t{1} << log2_places_; }
  /// Where the key is, or else where there is room for it.
  std::size_t find(std::uint64_t key) const;
  void grow();

  std::vector<std::uint64_t> keys_;  ///< in the order of insertion, to fill a larger table
  FastClearArray<Slot> table_;
  int log2_places_ = 8;
};

/// Two faces that cross: where the segment that they share starts and ends.
struct CrossingPair {
  Index face_E, face_F;
  CrossingNode start, end;
};

/// What one of several threads finds.
struct alignas(kApart) PairsOfThread {
  NodePairs open;
  std::vector<CrossingPair> crossing;
};

/// Scratch memory of find_crossings.
struct CrossingScratch {
  CrossingIndex index;
  NodePairs open, next;
  std::vector<PairsOfThread> of_threads;
  std::vector<std::uint64_t> marks;  ///< of sort_ascending
};

/// What find_crossings may leave out, or has to do beside.
struct CrossingOptions {
  bool stop_at_first = false;    ///< return as soon as one crossing pair is known
  bool keep_candidates = false;  ///< fill Crossings::candidates
  bool filtered = true;          ///< false: every sign is found by exact arithmetic
};

/// Finds all crossings (PCM section 4) and the segments between them: each once, with its successor in the circulation
/// of (5), and both surfaces' intersected faces. Exact on the rounded problem. True where there is a crossing.
///
/// Degenerate cases, those of meshes/generate/degenerate: a vertex on a vertex, an edge or a face is moved off it by
/// the tie rule, and each of its edges decided alone, by signs that agree; two edges that meet cross or don't; an edge
/// in the plane of a face, faces in one plane and a face without area never cross. Each crossing pair of faces has
/// exactly two crossings.
///
/// Where many pairs of nodes may touch, all threads of the team search below them; but for a search that stops, and for
/// one that keeps candidates, over which bounds are summed in the order they are found.
bool find_crossings(PosedPair& posed, const CrossingOptions& options, PosedTeam& team, CrossingScratch& scratch,
                    Crossings& crossings);

/// The same, where it is known which pairs cross.
void find_crossings_among(const TrackedPairs& pairs, PosedPair& posed, CrossingScratch& scratch, Crossings& crossings);

/// Computes the positions of all crossings: edge meets face plane. No edge crosses a face in whose plane it lies, nor a
/// face without area: the tie rule moves all of E one way off such a plane, by more than anything of F. So positions
/// are where crossings tend to as the tie rule's move vanishes, and so are all areas made of them. Off by a few ulps of
/// the face and edge sizes over the sine of the angle between them.
void locate_crossings(PosedPair& posed, Crossings& crossings);

/// Lists each edge's crossings in the order of `order`, or in that of Crossings::nodes where it is empty.
void list_crossings_by_edge(const PosedPair& posed, const std::vector<Index>& order, Crossings& crossings);

}  // namespace pcm::fast
