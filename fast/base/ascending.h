// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pcm/triangle_mesh.h"

namespace pcm::fast {

/// Sorts indices that all differ. Where they lie densely, as the faces of a patch do, by marking them in a bitmap: O(n)
/// rather than O(n log n). `marks` is scratch memory.
inline void sort_ascending(std::vector<Index>& indices, std::vector<std::uint64_t>& marks) {
  if (indices.size() < 2) return;
  const auto [least, greatest] = std::minmax_element(indices.begin(), indices.end());
  const auto first = static_cast<std::size_t>(*least);
  const std::size_t words = (static_cast<std::size_t>(*greatest) - first) / 64 + 1;
  if (words > 4 * indices.size()) {
    std::sort(indices.begin(), indices.end());
    return;
  }
  marks.assign(words, 0);
  for (const Index i : indices) {
    const std::size_t bit = static_cast<std::size_t>(i) - first;
    marks[bit / 64] |= std::uint64_t{1} << bit % 64;
  }
  auto next = indices.begin();
  for (std::size_t word = 0; word < words; ++word) {
    for (std::uint64_t left = marks[word]; left != 0; left &= left - 1) {
      *next++ = static_cast<Index>(first + 64 * word + static_cast<std::size_t>(std::countr_zero(left)));
    }
  }
}

}  // namespace pcm::fast
