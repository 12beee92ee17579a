// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/pose/box_tree.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace pcm::reference {

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  std::vector<Index> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<Eigen::Vector3d> twice_centre;
  twice_centre.reserve(boxes.size());
  for (const Box& box : boxes) twice_centre.push_back(box.lower + box.upper);

  struct Range {
    std::size_t first, last;
    Index parent;  ///< whose second half this is; kNone where it is a first half
  };
  nodes_.reserve(2 * boxes.size() - 1);
  std::vector<Range> waiting{{0, boxes.size(), kNone}};
  while (!waiting.empty()) {
    const Range range = waiting.back();
    waiting.pop_back();
    const Index at = static_cast<Index>(nodes_.size());
    if (range.parent != kNone) nodes_[range.parent].right = at;
    Box around = boxes[order[range.first]];
    for (std::size_t i = range.first + 1; i < range.last; ++i) around.include(boxes[order[i]]);
    nodes_.push_back({around, kNone, order[range.first]});
    if (range.last - range.first == 1) continue;
    int axis = 0;
    (around.upper - around.lower).maxCoeff(&axis);
    const std::size_t middle = range.first + (range.last - range.first) / 2;
    const auto begin = order.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(range.first), begin + static_cast<std::ptrdiff_t>(middle),
                     begin + static_cast<std::ptrdiff_t>(range.last),
                     [&](Index a, Index b) { return twice_centre[a][axis] < twice_centre[b][axis]; });
    waiting.push_back({middle, range.last, at});
    waiting.push_back({range.first, middle, kNone});  // on top, so that it follows its parent
  }
}

BoxTree::BoxTree(const BoxTree& tree, const std::vector<Box>& boxes) : nodes_(tree.nodes_) {
  assert(nodes_.empty() ? boxes.empty() : boxes.size() == (nodes_.size() + 1) / 2);
  for (std::size_t at = nodes_.size(); at-- > 0;) {
    Node& node = nodes_[at];
    if (node.right == kNone) {
      node.box = boxes[node.index];
    } else {
      node.box = nodes_[at + 1].box;
      node.box.include(nodes_[node.right].box);
    }
  }
}

std::vector<Box> boxes_of_faces(const TriangleMesh& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.faces.size());
  for (const Triangle& t : mesh.faces) {
    Box box{mesh.vertices[t[0]], mesh.vertices[t[0]]};
    for (const Index v : t) box.include({mesh.vertices[v], mesh.vertices[v]});
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace pcm::reference
