// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <utility>
#include <vector>

#include "fast/base/prefetch.h"
#include "fast/posed/placement.h"
#include "fast/simd/overlap.h"
#include "fast/simd/overlap_sets.h"
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

/// The search for pairs of faces whose boxes may touch and neither of which surely lies on one side of the other's
/// plane (PCM section 3), and for all of which `visit(face of E, face of F, SureSigns)` is called, until it returns
/// false. From the root pair down, each pair of nodes that may touch is replaced by the pairs of its wider node's
/// children with the other node, or of both nodes' children where they are about as wide. Every crossing pair of the
/// rounded problem is among those visited, and of any problem whose F has its vertices within their rounding; each
/// once; their order means nothing. With a margin, m, every pair that crosses at a pose near by is visited too, and
/// what `SureSigns` says of passing holds there; what it says of corners is of this pose alone (WidePose).
class CandidateSearch {
 public:
  /// Leaves the root pair open, or nothing.
  CandidateSearch(const PreparedSurface& E, const PreparedSurface& F, const Placement& placement, double margin,
                  NodePairs& open, WorkCounters& work)
      : tree_E_(E.wide_tree), tree_F_(F.wide_tree), test_(fastest_wide_tests()) {
    open.clear();
    ++work.box_tests;
    if (!boxes_may_touch(placement, E.tree.root().box, F.tree.root().box, margin)) return;
    pose_ = WidePose(tree_E_, tree_F_, placement, margin);
    open.emplace_back(0, 0);
  }

  /// Visits what is below the open pairs, and leaves none of them unless it is stopped.
  template <class Visit>
  void visit_below(NodePairs& open, WorkCounters& work, const Visit& visit) const {
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (open.size() > 1) prefetch_faces(tree_E_, tree_F_, open[open.size() - 2]);
      if (!are_bottom(i, j)) {
        split(i, j, open, work);
      } else if (!visit_faces(tree_E_.node(i), tree_F_.node(j), work, visit)) {
        return;
      }
    }
  }

  /// Replaces all open pairs but those of bottom nodes, again and again, until there are as many as asked for or
  /// none but those. `next` is scratch.
  void descend(std::size_t pairs, NodePairs& open, NodePairs& next, WorkCounters& work) const {
    for (bool some = true; some && open.size() < pairs;) {
      some = false;
      next.clear();
      for (const auto& [i, j] : open) {
        const bool bottom = are_bottom(i, j);
        if (bottom) {
          next.emplace_back(i, j);
        } else {
          split(i, j, next, work);
        }
        some = some || !bottom;
      }
      open.swap(next);
    }
  }

 private:
  /// Of two nodes the one that is wider by more than this is opened alone, else both are: the boxes of a node's eight
  /// children are nearly three times narrower than it is.
  static constexpr float kMuchWider = 2;

  bool are_bottom(Index i, Index j) const { return tree_E_.node(i).bottom() && tree_F_.node(j).bottom(); }

  /// Nodes and faces of one pair are on their way while others are tested: where poses differ, caches hold few of them.
  void add(Index i, Index j, NodePairs& open) const {
    prefetch(tree_E_.node(i));
    prefetch(tree_F_.node(j));
    open.emplace_back(i, j);
  }

  void split(Index i, Index j, NodePairs& open, WorkCounters& work) const {
    const WideNode& E = tree_E_.node(i);
    const WideNode& F = tree_F_.node(j);
    ++work.node_pairs;
    const float size_E = E.size(), size_F = pose_.scale * F.size();
    if (F.bottom() || (!E.bottom() && size_E > kMuchWider * size_F)) {
      work.box_tests += E.count;
      for (std::uint32_t lanes = test_.children_of_E(E, F, pose_); lanes != 0; lanes &= lanes - 1) {
        add(E.child[static_cast<std::size_t>(std::countr_zero(lanes))], j, open);
      }
    } else if (E.bottom() || size_F > kMuchWider * size_E) {
      work.box_tests += F.count;
      for (std::uint32_t lanes = test_.children_of_F(E, F, pose_); lanes != 0; lanes &= lanes - 1) {
        add(i, F.child[static_cast<std::size_t>(std::countr_zero(lanes))], open);
      }
    } else {
      work.box_tests += std::int64_t{E.count} * F.count;
      for (LanePairs pairs = test_.boxes(E, F, pose_); pairs != 0; pairs &= pairs - 1) {
        const int bit = std::countr_zero(pairs);
        add(E.child[static_cast<std::size_t>(bit % 8)], F.child[static_cast<std::size_t>(bit / 8)], open);
      }
    }
  }

  template <class Visit>
  bool visit_faces(const WideNode& E, const WideNode& F, WorkCounters& work, const Visit& visit) const {
    ++work.node_pairs;
    work.box_tests += std::int64_t{E.count} * F.count;
    const FacePairs pairs = test_.faces(E, tree_E_.group(E.group), F, tree_F_.group(F.group), pose_);
    work.face_rows += pairs.rows;
    work.live_lanes += pairs.live;
    for (LanePairs possible = pairs.possible; possible != 0; possible &= possible - 1) {
      const int bit = std::countr_zero(possible);
      ++work.candidate_pairs;
      if (!visit(E.child[static_cast<std::size_t>(bit % 8)], F.child[static_cast<std::size_t>(bit / 8)],
                 pairs.signs(bit))) {
        return false;
      }
    }
    return true;
  }

  const WideTree& tree_E_;
  const WideTree& tree_F_;
  const WideTests& test_;
  WidePose pose_;
};

/// Calls `visit` for all that such a search finds, until it returns false.
template <class Visit>
void for_each_candidate(const PreparedSurface& surface_E, const PreparedSurface& surface_F, const Placement& placement,
                        NodePairs& open, WorkCounters& work, const Visit& visit, double margin = 0) {
  CandidateSearch(surface_E, surface_F, placement, margin, open, work).visit_below(open, work, visit);
}

}  // namespace pcm::fast
