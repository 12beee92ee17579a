// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <utility>
#include <vector>

#include "fast/base/prefetch.h"
#include "fast/posed/placement.h"
#include "fast/simd/overlap.h"
#include "pcm/work_counters.h"

namespace pcm::fast {

/// The stack of the dual traversal; kept between evaluations.
using NodePairs = std::vector<std::pair<Index, Index>>;

/// Asks for the faces of two nodes, as far as they are bottom nodes.
inline void prefetch_faces(const WideTree& tree_E, const WideTree& tree_F, const std::pair<Index, Index>& nodes) {
  const WideNode& E = tree_E.node(nodes.first);
  const WideNode& F = tree_F.node(nodes.second);
  if (E.bottom()) prefetch(tree_E.group(E.group));
  if (F.bottom()) prefetch(tree_F.group(F.group));
}

/// Calls `visit(face of E, face of F, SureSigns)` for every pair of faces whose boxes may touch and neither of which
/// surely lies on one side of the other's plane (PCM section 3), until it returns false. From the root pair down, each
/// pair of nodes that may touch is replaced by the pairs of its wider node's children with the other node, or of both
/// nodes' children where they are about as wide. Every crossing pair of the rounded problem is among those visited, and
/// of any problem whose F has its vertices within their rounding; each once; their order means nothing. With a margin,
/// m, that and the signs hold for poses near by as well (WidePose).
template <class Visit>
void for_each_candidate(const PreparedSurface& surface_E, const PreparedSurface& surface_F, const Placement& placement,
                        const WideTests& test, NodePairs& open, WorkCounters& work, const Visit& visit,
                        double margin = 0) {
  ++work.box_tests;
  if (!boxes_may_touch(placement, surface_E.tree.root().box, surface_F.tree.root().box, margin)) return;
  const WideTree& tree_E = surface_E.wide_tree;
  const WideTree& tree_F = surface_F.wide_tree;
  const WidePose pose(tree_E, tree_F, placement, margin);
  // Eight surface boxes are nearly three times narrower than the one around them.
  constexpr float kMuchWider = 2;
  open.assign(1, {0, 0});
  // Nodes and faces of one pair are on their way while others are tested: where poses differ, caches hold few of them.
  const auto add = [&](Index i, Index j) {
    prefetch(tree_E.node(i));
    prefetch(tree_F.node(j));
    open.emplace_back(i, j);
  };
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (open.size() > 1) prefetch_faces(tree_E, tree_F, open[open.size() - 2]);
    const WideNode& E = tree_E.node(i);
    const WideNode& F = tree_F.node(j);
    if (E.bottom() && F.bottom()) {
      work.box_tests += std::int64_t{E.count} * F.count;
      const FacePairs pairs = test.faces(E, tree_E.group(E.group), F, tree_F.group(F.group), pose);
      for (LanePairs possible = pairs.possible; possible != 0; possible &= possible - 1) {
        const int bit = std::countr_zero(possible);
        ++work.candidate_pairs;
        if (!visit(E.child[static_cast<std::size_t>(bit % 8)], F.child[static_cast<std::size_t>(bit / 8)],
                   pairs.signs(bit))) {
          return;
        }
      }
      continue;
    }
    const float size_E = E.size(), size_F = pose.scale * F.size();
    if (F.bottom() || (!E.bottom() && size_E > kMuchWider * size_F)) {
      work.box_tests += E.count;
      for (std::uint32_t lanes = test.children_of_E(E, F, pose); lanes != 0; lanes &= lanes - 1) {
        add(E.child[static_cast<std::size_t>(std::countr_zero(lanes))], j);
      }
    } else if (E.bottom() || size_F > kMuchWider * size_E) {
      work.box_tests += F.count;
      for (std::uint32_t lanes = test.children_of_F(E, F, pose); lanes != 0; lanes &= lanes - 1) {
        add(i, F.child[static_cast<std::size_t>(std::countr_zero(lanes))]);
      }
    } else {
      work.box_tests += std::int64_t{E.count} * F.count;
      for (LanePairs pairs = test.boxes(E, F, pose); pairs != 0; pairs &= pairs - 1) {
        const int bit = std::countr_zero(pairs);
        add(E.child[static_cast<std::size_t>(bit % 8)], F.child[static_cast<std::size_t>(bit / 8)]);
      }
    }
  }
}

}  // namespace pcm::fast
