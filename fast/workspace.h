// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "fast/candidates.h"
#include "fast/contact.h"
#include "fast/engine.h"
#include "fast/footprint.h"
#include "fast/line_search.h"
#include "fast/line_trace.h"
#include "fast/placement.h"
#include "fast/projected_face.h"
#include "fast/separation.h"
#include "fast/stamped_array.h"
#include "fast/transform.h"
#include "fast/wide_elements.h"

namespace pcm::fast {

inline Side opposite(Side side) {
  return side == Side::E ? Side::F : Side::E;
}

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

  /// R14: E before F, then by the edge's vertices, then by face; edges are numbered in the order of their vertices.
  std::uint64_t key() const {
    return (static_cast<std::uint64_t>(edge_side) << 63) | (static_cast<std::uint64_t>(edge) << 31) |
           static_cast<std::uint64_t>(face);
  }
  /// Change of the winding number of the face's surface along the edge, from its smaller to its greater vertex.
  int winding_change() const { return from_above ? 1 : -1; }
};

/// The crossings of one edge.
struct EdgeCrossings {
  Index first = -1;  ///< in Workspace::Data::crossings; the others follow by next_on_edge
  Index count = 0;
  Index winding_change = 0;  ///< sum over them, from the smaller vertex to the greater
};

/// What is known about a vertex with respect to an open surface (rule R5), as bits.
enum Label : std::uint8_t { kNoLabel = 0, kInside = 1, kOutside = 2 };

/// One side of the contact: its surface in Me and what the steps find out about it.
struct SideState {
  PosedSurface posed;
  std::vector<Index> intersected;     ///< faces in a crossing pair; ascending once the crossings are found
  StampedArray<bool> is_intersected;  ///< by face
  StampedArray<EdgeCrossings> edge_crossings;
  StampedArray<Index> winding;       ///< by vertex of intersected faces: of the other surface where that is closed
  StampedArray<Index> face_winding;  ///< by face, the same: of inner ones and pockets; marks of intersected ones
  StampedArray<std::uint8_t> label;  ///< by vertex, Label bits, where the other surface is open
  std::vector<Index> inner;          ///< uncrossed faces inside the other body, ascending; nested ones included
  std::vector<Index> pockets;        ///< uncrossed faces of negative winding number: the other surface folded over
  StampedArray<Index> region;        ///< by vertex: inside vertices joined by uncrossed edges share one
  StampedArray<bool> component_crossed;
  StampedArray<Index> slave_nearby;             ///< by face, of masters: a face of the slave near its penetration line
  StampedArray<Index> slot;                     ///< by face: its place in `intersected`
  std::vector<double> clipped_area;             ///< of each intersected face
  std::vector<Eigen::Vector3d> clip_origin_Me;  ///< a point of each intersected face's patch

  // Where bounds are wanted, of masters only: what all positions of F's vertices within their rounding boxes agree on.
  StampedArray<bool> surely_crossed;   ///< by face: in a crossing pair in all of them
  StampedArray<bool> undecided;        ///< by face: active in some, not in others
  std::vector<Index> undecided_faces;  ///< all that are `undecided`

  const Surface::Data& surface() const { return posed.surface(); }
};

/// Crossings by key: open addressing, emptied in constant time.
class CrossingIndex {
 public:
  void start();
  /// The place of the crossing with this key in the list; `fresh` is entered and returned where it is new.
  Index find_or_insert(std::uint64_t key, Index fresh);

 private:
  struct Slot {
    std::uint64_t key = 0;
    Index value = -1;
  };
  void grow();
  std::vector<std::uint64_t> keys_;  ///< in the order of insertion, to fill a larger table
  StampedArray<Slot> table_;
  std::size_t capacity_ = 0;
};

/// Accumulates the clipped area of one intersected face.
struct FaceClip {
  Eigen::Vector3d origin_Me = Eigen::Vector3d::Zero();
  Eigen::Vector3d twice_vector_area_Me = Eigen::Vector3d::Zero();
  bool started = false;
  bool undefined = false;  ///< a border of the other surface ends inside the face
};

/// Empties the answer and keeps its memory.
void clear(Contact& contact);

struct Workspace::Data {
  std::array<SideState, 2> sides;
  Placement placement;
  const WideTests& wide_tests = fastest_wide_tests();
  const WideElements& wide_elements = fastest_wide_elements();
  ElementLanes element_lanes;
  NodePairs node_pairs;
  std::vector<Index> nodes;          ///< stack of the traversals of one tree
  LineNodes line_nodes;              ///< of the searches along lines
  std::vector<Index> stack;          ///< of the floods over a mesh
  std::vector<Index> flooded;        ///< room for all faces of a surface
  std::vector<std::uint64_t> marks;  ///< of sort_ascending
  std::vector<std::pair<Index, Index>>
      candidates;        ///< face pairs (E, F) whose boxes may touch; where bounds are wanted
  LineTrace line_trace;  ///< of the line at hand, where bounds are wanted
  std::vector<CrossingNode> crossings;
  CrossingIndex crossing_index;
  std::vector<Polygon> polygons;
  std::vector<Index> polygon_order;
  std::vector<Index> crossing_order;  ///< crossings of all polygons, one polygon after the other
  std::vector<Index> crossing_order_sorted;
  std::vector<Index> parents;  ///< disjoint sets of polygons and inside regions
  std::vector<Index> patch_of_set;
  std::vector<std::pair<Index, Index>> face_sets;  ///< ranges of set_faces (open other surface)
  std::vector<Index> set_faces;
  std::vector<std::uint8_t> set_labels;
  StampedArray<Index> set_of_face;
  std::vector<FaceClip> clips;
  ProjectionScratch projection;
  SightScratch sight;  ///< where bounds are wanted
  Contact contact;
  Contact apart;  ///< what a scene says of pairings it need not look at
  BoxPairs gaps;  ///< of searches for a distance

  SideState& side(Side s) { return sides[static_cast<std::size_t>(s)]; }
  const SideState& side(Side s) const { return sides[static_cast<std::size_t>(s)]; }
};

}  // namespace pcm::fast
