// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

namespace pcm::fast {

/// What is still to be visited on the way through a BoxTree, the last pushed first; allocates nothing. Where each node
/// that is taken leaves its two children, no more wait than one on each level and one besides, and halving at most 2^30
/// faces makes 30 levels below the root.
template <class Node>
class OpenNodes {
 public:
  bool empty() const { return count_ == 0; }
  void push(const Node& node) {
    assert(count_ < nodes_.size());
    nodes_[count_++] = node;
  }
  Node pop() { return nodes_[--count_]; }

 private:
  std::array<Node, 32> nodes_;
  std::size_t count_ = 0;
};

}  // namespace pcm::fast
