// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "pcm/triangle_mesh.h"
#include "reference/pose/box.h"

namespace pcm::reference {

constexpr Index kNone = -1;

/// Boxes in a balanced binary tree, for finding those that meet others, or looking along a line from near to far. A
/// range of boxes is halved at the median of their centres along the longest axis of the box around them.
class BoxTree {
 public:
  BoxTree() = default;
  /// O(n log n). Keeps a copy of the boxes.
  explicit BoxTree(const std::vector<Box>& boxes);
  /// As many other boxes, parted as `tree` parts its own: O(n), and as good where a body has moved as a whole.
  BoxTree(const BoxTree& tree, const std::vector<Box>& boxes);

  struct Node {
    Box box;
    Index right;  ///< second half, kNone at a leaf; the first half follows its parent
    Index index;  ///< of a leaf's box
  };
  /// A parent before its halves, the root first; empty where there is no box.
  const std::vector<Node>& nodes() const { return nodes_; }

  /// Calls visit(index) for each box that meets the given one, in no particular order.
  template <class Visit>
  void for_each_meeting(const Box& box, const Visit& visit) const {
    look_along([&box](const Box& mine) { return mine.meets(box) ? 0.0 : -1.0; },
               [&visit](Index index) {
                 visit(index);
                 return std::numeric_limits<double>::infinity();
               });
  }

  /// Visits the boxes that may hold what is looked for, nearer ones first where the tree tells. `begin_of(box)` is a
  /// lower bound of the distance at which the box begins, negative where it need not be looked at; it must not be
  /// greater for a box around another. `visit(index)` returns the greatest distance still of interest, less than 0 to
  /// stop.
  template <class BeginOf, class Visit>
  void look_along(const BeginOf& begin_of, const Visit& visit) const {
    struct Waiting {
      double from;
      Index node;
    };
    double limit = std::numeric_limits<double>::infinity();
    std::vector<Waiting> waiting;
    const auto enter = [&](Index node) {
      const double from = begin_of(nodes_[node].box);
      if (from >= 0 && from <= limit) waiting.push_back({from, node});
    };
    if (!nodes_.empty()) enter(0);
    while (!waiting.empty()) {
      const auto [from, at] = waiting.back();
      waiting.pop_back();
      if (from > limit) continue;
      const Node& node = nodes_[at];
      if (node.right == kNone) {
        limit = std::min(limit, visit(node.index));
        continue;
      }
      const std::size_t before = waiting.size();
      enter(at + 1);
      enter(node.right);
      if (waiting.size() == before + 2 && waiting[before].from < waiting[before + 1].from)
        std::swap(waiting[before], waiting[before + 1]);  // the nearer one on top
    }
  }

 private:
  std::vector<Node> nodes_;
};

/// The box of each face.
std::vector<Box> boxes_of_faces(const TriangleMesh& mesh);

}  // namespace pcm::reference
