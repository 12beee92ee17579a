// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/validity/edge_table.h"

#include <algorithm>

namespace pcm {
namespace {

struct HalfEdge {
  Index high = 0;  // the other end; the lower one is known from the bucket
  EdgeUse use;
};

}  // namespace

EdgeTable::EdgeTable(std::size_t vertex_count, const std::vector<Triangle>& faces, const std::vector<bool>& usable) {
  // Counting sort by the lower vertex, then each small bucket by the higher one.
  const auto for_each_use = [&](const auto& action) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!usable[f]) continue;
      for (std::uint8_t k = 0; k < 3; ++k) {
        const Index from = faces[f][k];
        const Index to = faces[f][(k + 1U) % 3];
        action(std::min(from, to), std::max(from, to), EdgeUse{static_cast<Index>(f), k, from < to});
      }
    }
  };
  std::vector<std::size_t> bucket(vertex_count + 1, 0);
  for_each_use([&](Index low, Index, const EdgeUse&) { ++bucket[static_cast<std::size_t>(low) + 1]; });
  for (std::size_t v = 0; v < vertex_count; ++v) bucket[v + 1] += bucket[v];
  std::vector<HalfEdge> half_edges(bucket[vertex_count]);
  std::vector<std::size_t> next = bucket;
  for_each_use([&](Index low, Index high, const EdgeUse& use) {
    half_edges[next[static_cast<std::size_t>(low)]++] = HalfEdge{high, use};
  });

  uses_.reserve(half_edges.size());
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto begin = half_edges.begin() + static_cast<std::ptrdiff_t>(bucket[v]);
    const auto end = half_edges.begin() + static_cast<std::ptrdiff_t>(bucket[v + 1]);
    std::sort(begin, end, [](const HalfEdge& a, const HalfEdge& b) {
      return a.high != b.high ? a.high < b.high : a.use.face < b.use.face;
    });
    for (auto it = begin; it != end; ++it) {
      if (it == begin || it->high != (it - 1)->high) {
        first_use_.push_back(uses_.size());
        ends_.push_back({static_cast<Index>(v), it->high});
      }
      uses_.push_back(it->use);
    }
  }
  first_use_.push_back(uses_.size());
}

}  // namespace pcm
