// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// A face's use of one of its edges.
struct EdgeUse {
  Index face = 0;
  std::uint8_t corner = 0;  ///< the edge runs from this corner of the face to the next
  bool forward = true;      ///< the face's winding takes it from the lower to the higher vertex
};

/// The undirected edges of any triangles, manifold or not, each with all the faces at it: what a check looks at.
///
/// Edges are ordered by (lower vertex, higher vertex), the uses of one by face. Flat arrays; linear time and memory but
/// for vertices of very many edges, which are sorted.
class EdgeTable {
 public:
  /// Only the faces `i` with `usable[i]` are entered; their vertices must be distinct and below `vertex_count`.
  EdgeTable(std::size_t vertex_count, const std::vector<Triangle>& faces, const std::vector<bool>& usable);

  std::size_t size() const { return ends_.size(); }
  /// The end vertices of edge i, the lower first.
  const std::array<Index, 2>& ends(std::size_t i) const { return ends_[i]; }
  std::span<const EdgeUse> uses(std::size_t i) const {
    return std::span(uses_).subspan(first_use_[i], first_use_[i + 1] - first_use_[i]);
  }

 private:
  std::vector<std::array<Index, 2>> ends_;
  std::vector<EdgeUse> uses_;
  std::vector<std::size_t> first_use_;
};

}  // namespace pcm
