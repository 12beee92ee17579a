// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/crossings/polygons.h"

#include <algorithm>

namespace pcm::reference {

std::vector<Chain> chain_polygons(const Crossings& crossings) {
  // A crossing ends the segment of one face at its edge and starts that of the other; at a border it does one of both.
  std::vector<Index> next(crossings.ids.size(), kNone);
  std::vector<bool> is_end(crossings.ids.size(), false);
  for (const Segment& segment : crossings.segments) {
    next[segment.start] = segment.end;
    is_end[segment.end] = true;
  }
  std::vector<Chain> chains;
  std::vector<bool> visited(crossings.ids.size(), false);
  const auto follow = [&](Index first, bool closed) {
    Chain chain;
    chain.closed = closed;
    for (Index point = first; point != kNone && !visited[point]; point = next[point]) {
      visited[point] = true;
      chain.points.push_back(point);
    }
    chains.push_back(chain);
  };
  const Index count = static_cast<Index>(crossings.ids.size());
  for (Index point = 0; point < count; ++point)
    if (!is_end[point]) follow(point, false);
  for (Index point = 0; point < count; ++point)
    if (!visited[point]) follow(point, true);
  std::sort(chains.begin(), chains.end(), [](const Chain& a, const Chain& b) { return a.points[0] < b.points[0]; });
  return chains;
}

}  // namespace pcm::reference
