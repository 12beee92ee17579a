// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/search/prism_search.h"

#include <algorithm>
#include <bit>

#include "fast/simd/overlap_sets.h"

namespace pcm::fast {

TreePrism prism_in_tree(const PosedPair& posed, Side side, const MasterPrism& prism, double wider_by) {
  const Placement& placement = posed.placement;
  // A box's point is off by the position error along each of three axes.
  const double box_error = 4 * placement.position_error(side) + farthest_off(prism, placement) + wider_by;
  return side == Side::E ? TreePrism(prism, box_error) : TreePrism(prism, box_error, placement.A, placement.r_Me);
}

void list_faces_in_prism(PosedPair& posed, Side side, const TreePrism& prism, double deepest, std::vector<Index>& open,
                         std::vector<Index>& faces) {
  const PreparedSurface& surface = posed.surface(side);
  faces.clear();
  open.assign(1, 0);
  const WidePrism wide_prism(surface.wide_tree, prism, deepest);
  const WideTests& tests = fastest_wide_tests();
  while (!open.empty()) {
    const WideNode& node = surface.wide_tree.node(open.back());
    open.pop_back();
    posed.work.box_tests += node.count;
    std::vector<Index>& children = node.bottom() ? faces : open;
    for (std::uint32_t lanes = tests.boxes_in_prism(node, wide_prism); lanes != 0; lanes &= lanes - 1) {
      children.push_back(node.child[static_cast<std::size_t>(std::countr_zero(lanes))]);
    }
  }
  std::sort(faces.begin(), faces.end());
}

}  // namespace pcm::fast
