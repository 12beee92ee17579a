// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "fast/simd/overlap.h"
#include "pcm/work_counters.h"

namespace pcm::fast {

/// The nodes a search along a line has yet to look into, with the distance at which the line enters each, in the
/// tree's unit.
using LineNodes = std::vector<std::pair<float, Index>>;

/// What is known, without a doubt, of a line and a face.
enum class Passage : std::uint8_t {
  unknown,   ///< it may miss it
  leaving,   ///< it passes through, along the face's normal
  entering,  ///< it passes through, against the normal
};

/// Calls `visit(face, passage)` for every face of the tree's surface that the line of `ray` may meet at most `limit`
/// metres along it, nearer boxes first; `visit` may lower the limit. Returns how far along the line every such face
/// surely was visited, m.
template <class Visit>
double search_along(const WideTree& tree, const WideRay& ray, const double& limit, const WideTests& test,
                    LineNodes& open, WorkCounters& work, const Visit& visit) {
  // Entries are never too great; a limit rounded to nearest may be too small by an ulp.
  const auto beyond = [&](float entry) { return entry * tree.unit() > limit * (1 + 0x1p-20); };
  double searched = std::numeric_limits<double>::infinity();
  const auto pass_by = [&](float entry) { searched = std::fmin(searched, entry * tree.unit()); };
  open.assign(1, {0, 0});
  while (!open.empty()) {
    const auto [entry, index] = open.back();
    open.pop_back();
    if (beyond(entry)) {
      pass_by(entry);
      continue;
    }
    const WideNode& node = tree.node(index);
    work.box_tests += node.count;
    Lanes entries;
    std::uint32_t lanes = test.boxes_met(node, ray, entries);
    FacesMet met;
    if (node.bottom() && lanes != 0) {
      met = test.faces_met(tree.group(node.group), ray);
      lanes &= met.possible;
    }
    const std::size_t before = open.size();
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      const float child_entry = entries.value[lane];
      if (beyond(child_entry)) {
        pass_by(child_entry);
      } else if (node.bottom()) {
        visit(node.child[lane], (met.leaving >> lane & 1U) != 0    ? Passage::leaving
                                : (met.entering >> lane & 1U) != 0 ? Passage::entering
                                                                   : Passage::unknown);
      } else {
        // The nearest on top.
        std::size_t at = open.size();
        open.emplace_back();
        for (; at > before && open[at - 1].first < child_entry; --at) open[at] = open[at - 1];
        open[at] = {child_entry, node.child[lane]};
      }
    }
  }
  return searched;
}

}  // namespace pcm::fast
