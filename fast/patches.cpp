// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/polygons.h"

namespace pcm::fast {

namespace {

Index root_of(std::vector<Index>& parents, Index i) {
  while (parents[static_cast<std::size_t>(i)] != i) {
    Index& parent = parents[static_cast<std::size_t>(i)];
    parent = parents[static_cast<std::size_t>(parent)];
    i = parent;
  }
  return i;
}

void join(std::vector<Index>& parents, Index i, Index j) {
  parents[static_cast<std::size_t>(root_of(parents, i))] = root_of(parents, j);
}

/// Calls `visit(v)` for vertices known to be inside the other body, some of them several times: winding number at least
/// 1, or labelled inside. Where the other surface is closed, those of intersected faces alone: what they are joined to
/// by uncrossed edges is inside with them.
template <class Visit>
void for_each_inside_vertex(const SideState& side, bool other_closed, const Visit& visit) {
  if (!other_closed) {
    for (const Index face : side.inner) {
      for (const Index v : side.surface().face(face)) visit(v);
    }
  }
  for (const Index face : side.intersected) {
    for (const Index v : side.surface().face(face)) {
      if (other_closed ? side.winding.at(v) >= 1 : (side.label.get(v, kNoLabel) & kInside) != 0) visit(v);
    }
  }
}

/// Numbers the regions of inside vertices joined by uncrossed edges; each becomes a set after the polygons' sets.
void flood_regions(Workspace::Data& workspace, Side side_name) {
  SideState& side = workspace.side(side_name);
  const Surface::Data& surface = side.surface();
  const bool other_closed = workspace.side(opposite(side_name)).surface().closed;
  side.region.start(surface.mesh.vertices.size());
  // What an open surface does not label inside is not entered.
  const Index not_entered = other_closed ? -1 : 0;
  for_each_inside_vertex(side, other_closed, [&side](Index v) { side.region[v] = -1; });
  for_each_inside_vertex(side, other_closed, [&](Index seed) {
    if (side.region[seed] >= 0) return;
    const auto region = static_cast<Index>(workspace.parents.size());
    workspace.parents.push_back(region);
    side.region[seed] = region;
    workspace.stack.assign(1, seed);
    while (!workspace.stack.empty()) {
      const Index v = workspace.stack.back();
      workspace.stack.pop_back();
      for (const Index edge : surface.vertex_edges[v]) {
        if (side.edge_crossings.contains(edge)) continue;
        const Index u = surface.other_end(edge, v);
        if (side.region.get(u, not_entered) >= 0) continue;
        side.region[u] = region;
        workspace.stack.push_back(u);
      }
    }
  });
}

}  // namespace

void group_patches(Workspace::Data& workspace) {
  if (workspace.polygons.size() <= 1) {
    for (Polygon& polygon : workspace.polygons) polygon.patch = 0;
    workspace.contact.patches = static_cast<Index>(workspace.polygons.size());
    return;
  }
  const auto& crossings = workspace.crossings;
  std::vector<Index>& parents = workspace.parents;
  parents.clear();
  for (std::size_t p = 0; p < workspace.polygons.size(); ++p) parents.push_back(static_cast<Index>(p));
  for (const Side side : {Side::E, Side::F}) flood_regions(workspace, side);
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    const CrossingNode& crossing = crossings[c];
    SideState& side = workspace.side(crossing.edge_side);
    const EdgeCrossings& list = side.edge_crossings[crossing.edge];
    if (list.first != static_cast<Index>(c)) continue;
    const std::array<Index, 2>& ends = side.surface().edge(crossing.edge);
    const Index regions[2] = {side.region.get(ends[0], -1), side.region.get(ends[1], -1)};
    if (list.count == 1) {
      for (const Index region : regions) {
        if (region >= 0) join(parents, region, crossing.polygon);
      }
    } else if (list.count == 2 && regions[0] < 0 && regions[1] < 0) {
      join(parents, crossing.polygon, crossings[static_cast<std::size_t>(crossing.next_on_edge)].polygon);
    }
  }
  workspace.patch_of_set.assign(parents.size(), -1);
  Index patches = 0;
  for (std::size_t p = 0; p < workspace.polygons.size(); ++p) {
    Index& patch = workspace.patch_of_set[static_cast<std::size_t>(root_of(parents, static_cast<Index>(p)))];
    if (patch < 0) patch = patches++;
    workspace.polygons[p].patch = patch;
  }
  workspace.contact.patches = patches;
}

}  // namespace pcm::fast
