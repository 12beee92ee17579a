// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/pose/surface.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace pcm::reference {

Index find_edge(const Surface& surface, std::array<Index, 2> edge) {
  const auto found = std::lower_bound(surface.edges.begin(), surface.edges.end(), edge);
  assert(found != surface.edges.end() && *found == edge);
  return static_cast<Index>(found - surface.edges.begin());
}

namespace {

void build_edges(Surface& surface) {
  const std::vector<Triangle>& faces = surface.mesh.faces;
  const auto edge_of = [](const Triangle& t, int i) {
    const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
    return std::array<Index, 2>{low, high};
  };
  for (const Triangle& t : faces)
    for (int i = 0; i < 3; ++i) surface.edges.push_back(edge_of(t, i));
  std::sort(surface.edges.begin(), surface.edges.end());
  surface.edges.erase(std::unique(surface.edges.begin(), surface.edges.end()), surface.edges.end());
  surface.edge_faces.assign(surface.edges.size(), {kNone, kNone});
  surface.face_edges.resize(faces.size());
  for (Index f = 0; f < static_cast<Index>(faces.size()); ++f)
    for (int i = 0; i < 3; ++i) {
      const Index edge = find_edge(surface, edge_of(faces[f], i));
      surface.face_edges[f][i] = edge;
      std::array<Index, 2>& owners = surface.edge_faces[edge];
      assert(owners[1] == kNone);
      (owners[0] == kNone ? owners[0] : owners[1]) = f;
    }
  surface.closed = std::all_of(surface.edge_faces.begin(), surface.edge_faces.end(),
                               [](const std::array<Index, 2>& owners) { return owners[1] != kNone; });
}

void label_components(Surface& surface) {
  const Index count = static_cast<Index>(surface.mesh.faces.size());
  surface.component.assign(count, kNone);
  std::vector<Index> front;
  for (Index seed = 0; seed < count; ++seed) {
    if (surface.component[seed] != kNone) continue;
    surface.component[seed] = surface.components;
    front.assign(1, seed);
    while (!front.empty()) {
      const Index face = front.back();
      front.pop_back();
      for (const Index edge : surface.face_edges[face])
        for (const Index next : surface.edge_faces[edge])
          if (next != kNone && surface.component[next] == kNone) {
            surface.component[next] = surface.components;
            front.push_back(next);
          }
    }
    ++surface.components;
  }
}

}  // namespace

Surface make_surface(TriangleMesh mesh) {
  Surface surface;
  surface.mesh = std::move(mesh);
  build_edges(surface);
  surface.vertex_faces.resize(surface.mesh.vertices.size());
  for (Index f = 0; f < static_cast<Index>(surface.mesh.faces.size()); ++f)
    for (const Index v : surface.mesh.faces[f]) surface.vertex_faces[v].push_back(f);
  label_components(surface);
  surface.tree = BoxTree(boxes_of_faces(surface.mesh));
  return surface;
}

}  // namespace pcm::reference
