// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare::published {

/// A box along the axes of its surface's frame, m.
struct Box {
  std::array<double, 3> centre{};
  std::array<double, 3> half{};
};

/// The smallest box about some points, but for rounding.
Box box_about(const Eigen::Vector3d* first, const Eigen::Vector3d* last);

/// The paper's hierarchy of bounding volumes (3.1): each box halves its items along its longest side, at the median of
/// their centres, and a leaf holds one item. Node 0 is the root; a node fills one cache line. Built in O(n log n).
class BoxTree {
 public:
  struct alignas(64) Node {
    Box box;
    Index child = -1;  ///< the first of two children side by side; -1 in a leaf
    Index item = -1;   ///< of a leaf
  };

  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& items);

  const Node& operator[](Index node) const { return nodes_[static_cast<std::size_t>(node)]; }

 private:
  std::vector<Node> nodes_;
};

/// What tests of boxes need of a pose, by rows.
struct Placement {
  std::array<std::array<double, 3>, 3> A{};
  std::array<std::array<double, 3>, 3> A_absolute{};
  std::array<double, 3> r_Me{};

  explicit Placement(const Pose& pose) {
    for (int i = 0; i < 3; ++i) {
      const auto row = static_cast<std::size_t>(i);
      for (int j = 0; j < 3; ++j) {
        A[row][static_cast<std::size_t>(j)] = pose.A(i, j);
        A_absolute[row][static_cast<std::size_t>(j)] = std::abs(pose.A(i, j));
      }
      r_Me[row] = pose.r[i];
    }
  }
};

/// The paper's test of two boxes, all in the frame of Me: F's box is enlarged to one along E's axes. 12 operations an
/// axis, and no further axis once one tells them apart, hence the 12 to 36 the paper states.
inline bool overlap(const Placement& placement, const Box& box_E, const Box& box_F) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& a = placement.A[i];
    const auto& b = placement.A_absolute[i];
    const double apart =
        a[0] * box_F.centre[0] + a[1] * box_F.centre[1] + a[2] * box_F.centre[2] + placement.r_Me[i] - box_E.centre[i];
    const double half_extents = b[0] * box_F.half[0] + b[1] * box_F.half[1] + b[2] * box_F.half[2] + box_E.half[i];
    if (std::abs(apart) > half_extents) return false;
  }
  return true;
}

/// Calls `visit(item_E, item_F)` for every two leaves whose boxes overlap: from the roots down, the four pairs of
/// children in turn. Returns the number of box tests. `open` is scratch memory.
template <class Visit>
std::int64_t for_each_overlap(const BoxTree& tree_E, const BoxTree& tree_F, const Placement& placement,
                              std::vector<std::pair<Index, Index>>& open, const Visit& visit) {
  std::int64_t tests = 0;
  const auto test = [&](Index node_E, Index node_F) {
    ++tests;
    if (overlap(placement, tree_E[node_E].box, tree_F[node_F].box)) open.emplace_back(node_E, node_F);
  };
  open.clear();
  test(0, 0);
  while (!open.empty()) {
    const auto [e, f] = open.back();
    open.pop_back();
    const BoxTree::Node& node_E = tree_E[e];
    const BoxTree::Node& node_F = tree_F[f];
    if (node_E.child < 0 && node_F.child < 0) {
      visit(node_E.item, node_F.item);
    } else if (node_F.child < 0) {
      test(node_E.child, f);
      test(node_E.child + 1, f);
    } else if (node_E.child < 0) {
      test(e, node_F.child);
      test(e, node_F.child + 1);
    } else {
      test(node_E.child, node_F.child);
      test(node_E.child, node_F.child + 1);
      test(node_E.child + 1, node_F.child);
      test(node_E.child + 1, node_F.child + 1);
    }
  }
  return tests;
}

}  // namespace pcm::compare::published
