// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/polygons.h"

#include <algorithm>

namespace pcm::fast {

namespace {

/// Walks from `start` along the circulation to the end of an open polygon or around a closed one.
void walk(Workspace::Data& workspace, Index start, bool closed) {
  auto& crossings = workspace.crossings;
  const auto number = static_cast<Index>(workspace.polygons.size());
  Polygon polygon;
  polygon.closed = closed;
  polygon.first = static_cast<Index>(workspace.crossing_order.size());
  Index at = start;
  do {
    CrossingNode& crossing = crossings[static_cast<std::size_t>(at)];
    crossing.polygon = number;
    workspace.crossing_order.push_back(at);
    at = crossing.next;
  } while (at >= 0 && at != start);
  polygon.count = static_cast<Index>(workspace.crossing_order.size()) - polygon.first;
  if (closed) {
    const auto begin = workspace.crossing_order.begin() + polygon.first;
    const auto smallest = std::min_element(begin, workspace.crossing_order.end(), [&](Index c, Index d) {
      return crossings[static_cast<std::size_t>(c)].key() < crossings[static_cast<std::size_t>(d)].key();
    });
    std::rotate(begin, smallest, workspace.crossing_order.end());
  }
  workspace.polygons.push_back(polygon);
}

}  // namespace

void chain_polygons(Workspace::Data& workspace) {
  auto& crossings = workspace.crossings;
  auto& polygons = workspace.polygons;
  polygons.clear();
  workspace.crossing_order.clear();
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    if (!crossings[i].has_previous) walk(workspace, static_cast<Index>(i), false);
  }
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    if (crossings[i].polygon < 0) walk(workspace, static_cast<Index>(i), true);
  }

  const auto first_key = [&](const Polygon& polygon) {
    const Index first = workspace.crossing_order[static_cast<std::size_t>(polygon.first)];
    return crossings[static_cast<std::size_t>(first)].key();
  };
  std::sort(polygons.begin(), polygons.end(),
            [&](const Polygon& a, const Polygon& b) { return first_key(a) < first_key(b); });
  workspace.crossing_order_sorted.clear();
  for (std::size_t number = 0; number < polygons.size(); ++number) {
    Polygon& polygon = polygons[number];
    const auto begin = static_cast<std::size_t>(polygon.first);
    polygon.first = static_cast<Index>(workspace.crossing_order_sorted.size());
    for (std::size_t i = begin; i < begin + static_cast<std::size_t>(polygon.count); ++i) {
      const Index c = workspace.crossing_order[i];
      crossings[static_cast<std::size_t>(c)].polygon = static_cast<Index>(number);
      workspace.crossing_order_sorted.push_back(c);
    }
  }
  std::swap(workspace.crossing_order, workspace.crossing_order_sorted);
}

void list_crossings_by_edge(Workspace::Data& workspace) {
  for (SideState& side : workspace.sides) side.edge_crossings.start(side.surface().edges.size());
  const bool chained = workspace.crossing_order.size() == workspace.crossings.size();
  // Each list grows at its head: the last crossing comes first.
  for (std::size_t i = workspace.crossings.size(); i-- > 0;) {
    const Index c = chained ? workspace.crossing_order[i] : static_cast<Index>(i);
    CrossingNode& crossing = workspace.crossings[static_cast<std::size_t>(c)];
    EdgeCrossings& list = workspace.side(crossing.edge_side).edge_crossings[crossing.edge];
    crossing.next_on_edge = list.first;
    list.first = c;
    ++list.count;
    list.winding_change += crossing.winding_change();
  }
}

}  // namespace pcm::fast
