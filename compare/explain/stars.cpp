// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/stars.h"

#include <algorithm>

namespace pcm::compare {

using reference::kNone;
using reference::Surface;

std::vector<Index> faces_at(const Surface& surface, const Feature& feature) {
  if (feature.kind == FeatureKind::face) return {feature.index[0]};
  if (feature.kind == FeatureKind::vertex) return surface.vertex_faces[static_cast<std::size_t>(feature.index[0])];
  std::vector<Index> faces;
  for (const Index f : surface.edge_faces[static_cast<std::size_t>(find_edge(surface, feature.index))])
    if (f != kNone) faces.push_back(f);
  return faces;
}

std::vector<std::array<Index, 2>> edges_at(const Surface& surface, const Feature& feature) {
  if (feature.kind == FeatureKind::edge) return {feature.index};
  std::vector<std::array<Index, 2>> edges;
  if (feature.kind != FeatureKind::vertex) return edges;
  for (const Index f : faces_at(surface, feature))
    for (const Index edge : surface.face_edges[static_cast<std::size_t>(f)]) {
      const std::array<Index, 2>& ends = surface.edges[static_cast<std::size_t>(edge)];
      if (ends[0] == feature.index[0] || ends[1] == feature.index[0]) edges.push_back(ends);
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace pcm::compare
