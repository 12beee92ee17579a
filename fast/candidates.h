// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "fast/contact.h"
#include "fast/placement.h"

namespace pcm::fast {

/// The stack of the dual traversal; kept between evaluations.
using NodePairs = std::vector<std::pair<Index, Index>>;

/// Calls `visit(face of E, face of F)` for every pair of faces whose boxes may touch (PCM section 3), until it returns
/// false. From the root pair down, each overlapping pair is replaced by the pairs of its wider box's children. Every
/// crossing pair of the rounded problem is among those visited, each once; their order means nothing.
template <class Visit>
void for_each_candidate(const Surface::Data& surface_E, const Surface::Data& surface_F, const Placement& placement,
                        NodePairs& open, WorkCounters& work, const Visit& visit) {
  open.clear();
  open.emplace_back(0, 0);
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    const BoxNode& node_E = surface_E.tree.node(i);
    const BoxNode& node_F = surface_F.tree.node(j);
    ++work.box_tests;
    if (!boxes_may_touch(placement, node_E.box, node_F.box)) continue;
    if (node_E.leaf() && node_F.leaf()) {
      ++work.candidate_pairs;
      if (!visit(node_E.face, node_F.face)) return;
      continue;
    }
    const bool split_E = node_F.leaf() || (!node_E.leaf() && node_E.box.half.maxCoeff() >= node_F.box.half.maxCoeff());
    if (split_E) {
      open.emplace_back(node_E.child, j);
      open.emplace_back(node_E.child + 1, j);
    } else {
      open.emplace_back(i, node_F.child);
      open.emplace_back(i, node_F.child + 1);
    }
  }
}

}  // namespace pcm::fast
