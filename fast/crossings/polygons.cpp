// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/crossings/polygons.h"

#include <algorithm>

namespace pcm::fast {

namespace {

/// Walks from `start` along the circulation to the end of an open polygon or around a closed one.
Polygon walk(std::vector<CrossingNode>& nodes, Index start, bool closed, Index number, std::vector<Index>& order) {
  Polygon polygon;
  polygon.closed = closed;
  polygon.first = static_cast<Index>(order.size());
  Index at = start;
  do {
    CrossingNode& crossing = nodes[static_cast<std::size_t>(at)];
    crossing.polygon = number;
    order.push_back(at);
    at = crossing.next;
  } while (at >= 0 && at != start);
  polygon.count = static_cast<Index>(order.size()) - polygon.first;
  if (closed) {
    const auto begin = order.begin() + polygon.first;
    const auto smallest = std::min_element(begin, order.end(), [&nodes](Index c, Index d) {
      return nodes[static_cast<std::size_t>(c)].key() < nodes[static_cast<std::size_t>(d)].key();
    });
    std::rotate(begin, smallest, order.end());
  }
  return polygon;
}

}  // namespace

void chain_polygons(Crossings& crossings, std::vector<Index>& unsorted, PolygonChains& chains) {
  std::vector<CrossingNode>& nodes = crossings.nodes;
  std::vector<Polygon>& polygons = chains.polygons;
  chains.clear();
  unsorted.clear();
  const auto add = [&](std::size_t start, bool closed) {
    const auto number = static_cast<Index>(polygons.size());
    polygons.push_back(walk(nodes, static_cast<Index>(start), closed, number, unsorted));
  };
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].has_previous) add(i, false);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].polygon < 0) add(i, true);
  }

  const auto first_key = [&](const Polygon& polygon) {
    return crossings[unsorted[static_cast<std::size_t>(polygon.first)]].key();
  };
  std::sort(polygons.begin(), polygons.end(),
            [&](const Polygon& a, const Polygon& b) { return first_key(a) < first_key(b); });
  for (std::size_t number = 0; number < polygons.size(); ++number) {
    Polygon& polygon = polygons[number];
    const auto begin = static_cast<std::size_t>(polygon.first);
    polygon.first = static_cast<Index>(chains.crossing_order.size());
    for (std::size_t i = begin; i < begin + static_cast<std::size_t>(polygon.count); ++i) {
      nodes[static_cast<std::size_t>(unsorted[i])].polygon = static_cast<Index>(number);
      chains.crossing_order.push_back(unsorted[i]);
    }
  }
}

}  // namespace pcm::fast
