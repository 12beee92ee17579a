// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/published/box_tree.h"

#include <algorithm>
#include <numeric>

namespace pcm::compare::published {
namespace {

/// The smallest box about some boxes, but for rounding.
Box box_about(const std::vector<Box>& items, const std::vector<Index>& order, std::size_t begin, std::size_t end) {
  Box whole;
  for (std::size_t i = 0; i < 3; ++i) {
    double lower = std::numeric_limits<double>::infinity(), upper = -lower;
    for (std::size_t k = begin; k < end; ++k) {
      const Box& box = items[static_cast<std::size_t>(order[k])];
      lower = std::min(lower, box.centre[i] - box.half[i]);
      upper = std::max(upper, box.centre[i] + box.half[i]);
    }
    whole.centre[i] = lower + (upper - lower) / 2;
    whole.half[i] = (upper - lower) / 2;
  }
  return whole;
}

}  // namespace

Box box_about(const Eigen::Vector3d* first, const Eigen::Vector3d* last) {
  Eigen::Vector3d lower = *first, upper = *first;
  for (const Eigen::Vector3d* point = first + 1; point != last; ++point) {
    lower = lower.cwiseMin(*point);
    upper = upper.cwiseMax(*point);
  }
  Box box;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    box.centre[i] = lower[axis] + (upper[axis] - lower[axis]) / 2;
    box.half[i] = (upper[axis] - lower[axis]) / 2;
  }
  return box;
}

BoxTree::BoxTree(const std::vector<Box>& items) {
  struct Part {
    Index node;
    std::size_t begin, end;
  };
  std::vector<Index> order(items.size());
  std::iota(order.begin(), order.end(), Index{0});
  nodes_.reserve(2 * items.size());
  nodes_.resize(1);
  std::vector<Part> open{{0, 0, items.size()}};
  while (!open.empty()) {
    const auto [node, begin, end] = open.back();
    open.pop_back();
    const Box box =
        end - begin == 1 ? items[static_cast<std::size_t>(order[begin])] : box_about(items, order, begin, end);
    nodes_[static_cast<std::size_t>(node)].box = box;
    if (end - begin == 1) {
      nodes_[static_cast<std::size_t>(node)].item = order[begin];
      continue;
    }
    const auto axis = static_cast<std::size_t>(std::max_element(box.half.begin(), box.half.end()) - box.half.begin());
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t k) { return order.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(middle), at(end), [&](Index a, Index b) {
      return items[static_cast<std::size_t>(a)].centre[axis] < items[static_cast<std::size_t>(b)].centre[axis];
    });
    const auto child = static_cast<Index>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[static_cast<std::size_t>(node)].child = child;
    open.push_back({child, begin, middle});
    open.push_back({child + 1, middle, end});
  }
}

}  // namespace pcm::compare::published
