// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "reference/active/active_areas.h"
#include "reference/numbers/disjoint_sets.h"

namespace pcm::reference {

std::vector<Index> group_into_patches(const ExactPose& pose, const Crossings& crossings,
                                      const std::vector<Chain>& polygons, const ActiveFaces& E, const ActiveFaces& F) {
  const std::size_t vertices_E = E.inside.size();
  const std::size_t first_polygon = vertices_E + F.inside.size();
  DisjointSets classes(first_polygon + polygons.size());  // of both surfaces' vertices and of polygons
  std::vector<std::size_t> polygon_of(crossings.ids.size());
  for (std::size_t i = 0; i < polygons.size(); ++i)
    for (const Index point : polygons[i].points) polygon_of[point] = first_polygon + i;

  for (const Side side : {Side::E, Side::F}) {
    const Surface& surface = pose.surface(side);
    const ActiveFaces& active = side == Side::E ? E : F;
    const std::size_t offset = side == Side::E ? 0 : vertices_E;
    std::vector<std::vector<std::size_t>> on_edge(surface.edges.size());
    for (std::size_t i = 0; i < crossings.ids.size(); ++i)
      if (crossings.ids[i].edge_side == side)
        on_edge[find_edge(surface, crossings.ids[i].edge)].push_back(polygon_of[i]);
    for (std::size_t i = 0; i < surface.edges.size(); ++i) {
      const auto [a, b] = surface.edges[i];
      const std::vector<std::size_t>& met = on_edge[i];
      const bool a_inside = active.inside[a], b_inside = active.inside[b];
      if (met.empty() && a_inside && b_inside) classes.join(offset + a, offset + b);
      if (met.size() == 1 && a_inside) classes.join(offset + a, met[0]);
      if (met.size() == 1 && b_inside) classes.join(offset + b, met[0]);
      if (met.size() == 2 && !a_inside && !b_inside) classes.join(met[0], met[1]);
    }
  }

  std::vector<Index> patches;
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const std::size_t root = classes.root(first_polygon + i);
    const auto known = std::find(roots.begin(), roots.end(), root);
    patches.push_back(static_cast<Index>(known - roots.begin()));
    if (known == roots.end()) roots.push_back(root);
  }
  return patches;
}

}  // namespace pcm::reference
