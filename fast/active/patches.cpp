// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/active/patches.h"

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
void for_each_inside_vertex(const PreparedSurface& surface, const std::vector<Index>& intersected,
                            const ActiveFaces& active, bool other_closed, const Visit& visit) {
  if (!other_closed) {
    for (const Index face : active.inner) {
      for (const Index v : surface.face(face)) visit(v);
    }
  }
  for (const Index face : intersected) {
    for (const Index v : surface.face(face)) {
      if (other_closed ? active.winding.at(v) >= 1 : (active.label.get(v, kNoLabel) & kInside) != 0) visit(v);
    }
  }
}

/// Numbers the regions of inside vertices joined by uncrossed edges; each becomes a set after the polygons' sets.
void flood_regions(const PosedPair& posed, const Crossings& crossings, const ActiveAreas& areas, Side side,
                   PatchScratch& scratch) {
  const PreparedSurface& surface = posed.surface(side);
  const CrossedSurface& crossed = crossings.of(side);
  const bool other_closed = posed.surface(opposite(side)).closed;
  FastClearArray<Index>& region_of = scratch.region[static_cast<std::size_t>(side)];
  region_of.start(surface.mesh.vertices.size());
  // What an open surface does not label inside is not entered.
  const Index not_entered = other_closed ? -1 : 0;
  const auto for_each_seed = [&](const auto& visit) {
    for_each_inside_vertex(surface, crossed.intersected, areas.of(side), other_closed, visit);
  };
  for_each_seed([&region_of](Index v) { region_of[v] = -1; });
  for_each_seed([&](Index seed) {
    if (region_of[seed] >= 0) return;
    const auto region = static_cast<Index>(scratch.parents.size());
    scratch.parents.push_back(region);
    region_of[seed] = region;
    scratch.stack.assign(1, seed);
    while (!scratch.stack.empty()) {
      const Index v = scratch.stack.back();
      scratch.stack.pop_back();
      for (const Index edge : surface.vertex_edges[v]) {
        if (crossed.edges.contains(edge)) continue;
        const Index u = surface.other_end(edge, v);
        if (region_of.get(u, not_entered) >= 0) continue;
        region_of[u] = region;
        scratch.stack.push_back(u);
      }
    }
  });
}

}  // namespace

void group_patches(const PosedPair& posed, const Crossings& crossings, const PolygonChains& chains,
                   const ActiveAreas& areas, PatchScratch& scratch, Patches& patches) {
  const std::size_t polygons = chains.polygons.size();
  patches.of_polygon.assign(polygons, 0);
  patches.count = static_cast<Index>(polygons);
  if (polygons <= 1) return;
  std::vector<Index>& parents = scratch.parents;
  parents.clear();
  for (std::size_t p = 0; p < polygons; ++p) parents.push_back(static_cast<Index>(p));
  for (const Side side : {Side::E, Side::F}) flood_regions(posed, crossings, areas, side, scratch);
  for (std::size_t c = 0; c < crossings.nodes.size(); ++c) {
    const CrossingNode& crossing = crossings.nodes[c];
    const EdgeCrossings& list = crossings.of(crossing.edge_side).edges.at(crossing.edge);
    if (list.first != static_cast<Index>(c)) continue;
    const FastClearArray<Index>& region_of = scratch.region[static_cast<std::size_t>(crossing.edge_side)];
    const std::array<Index, 2>& ends = posed.surface(crossing.edge_side).edge(crossing.edge);
    const Index regions[2] = {region_of.get(ends[0], -1), region_of.get(ends[1], -1)};
    if (list.count == 1) {
      for (const Index region : regions) {
        if (region >= 0) join(parents, region, crossing.polygon);
      }
    } else if (list.count == 2 && regions[0] < 0 && regions[1] < 0) {
      join(parents, crossing.polygon, crossings[crossing.next_on_edge].polygon);
    }
  }
  scratch.patch_of_set.assign(parents.size(), -1);
  patches.count = 0;
  for (std::size_t p = 0; p < polygons; ++p) {
    Index& patch = scratch.patch_of_set[static_cast<std::size_t>(root_of(parents, static_cast<Index>(p)))];
    if (patch < 0) patch = patches.count++;
    patches.of_polygon[p] = patch;
  }
}

}  // namespace pcm::fast
