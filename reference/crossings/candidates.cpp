// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/crossings/candidates.h"

#include <algorithm>

namespace pcm::reference {

// Of two nodes that meet the larger one is parted, so that both shrink alike.
std::vector<IndexPair> meeting_boxes(const BoxTree& a, const BoxTree& b) {
  using Node = BoxTree::Node;
  const auto is_leaf = [](const Node& node) { return node.right == kNone; };
  const auto size = [](const Node& node) { return (node.box.upper - node.box.lower).sum(); };
  std::vector<IndexPair> pairs, waiting;
  if (!a.nodes().empty() && !b.nodes().empty()) waiting.emplace_back(0, 0);
  while (!waiting.empty()) {
    const auto [i, j] = waiting.back();
    waiting.pop_back();
    const Node& node_a = a.nodes()[i];
    const Node& node_b = b.nodes()[j];
    if (!node_a.box.meets(node_b.box)) continue;
    if (is_leaf(node_a) && is_leaf(node_b)) {
      pairs.emplace_back(node_a.index, node_b.index);
    } else if (is_leaf(node_b) || (!is_leaf(node_a) && size(node_a) >= size(node_b))) {
      waiting.emplace_back(node_a.right, j);
      waiting.emplace_back(i + 1, j);
    } else {
      waiting.emplace_back(i, node_b.right);
      waiting.emplace_back(i, j + 1);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace pcm::reference
