// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/active/active_areas.h"

namespace pcm::fast {

namespace {

/// The set of uncrossed faces, connected by edges, that `seed` belongs to; made where it is new.
Index set_of(ActiveAreaScratch& scratch, const PreparedSurface& surface, const CrossedSurface& crossed, Index seed) {
  if (scratch.set_of_face.contains(seed)) return scratch.set_of_face[seed];
  const auto set = static_cast<Index>(scratch.face_sets.size());
  const auto begin = static_cast<Index>(scratch.set_faces.size());
  scratch.set_of_face[seed] = set;
  scratch.set_faces.push_back(seed);
  // The list of the set's faces is its own queue.
  for (std::size_t next = static_cast<std::size_t>(begin); next < scratch.set_faces.size(); ++next) {
    for (const Index face : surface.neighbours_of(scratch.set_faces[next])) {
      if (crossed.is_intersected.contains(face) || scratch.set_of_face.contains(face)) continue;
      scratch.set_of_face[face] = set;
      scratch.set_faces.push_back(face);
    }
  }
  scratch.face_sets.emplace_back(begin, static_cast<Index>(scratch.set_faces.size()));
  scratch.set_labels.push_back(kNoLabel);
  return set;
}

void label_vertex(ActiveFaces& side, std::vector<Index>& labelled, Index v, Label label) {
  std::uint8_t& bits = side.label[v];
  if (bits == kNoLabel) labelled.push_back(v);
  bits = static_cast<std::uint8_t>(bits | label);
}

}  // namespace

bool find_active_area_in_open(const PosedPair& posed, const Crossings& crossings, Side side, ActiveAreaScratch& scratch,
                              ActiveFaces& found) {
  const CrossedSurface& crossed = crossings.of(side);
  const PreparedSurface& surface = posed.surface(side);
  found.label.start(surface.mesh.vertices.size());
  scratch.set_of_face.start(surface.mesh.faces.size());
  scratch.face_sets.clear();
  scratch.set_faces.clear();
  scratch.set_labels.clear();

  std::vector<Index>& labelled = scratch.stack;
  labelled.clear();
  for (std::size_t c = 0; c < crossings.nodes.size(); ++c) {
    const CrossingNode& crossing = crossings.nodes[c];
    if (crossing.edge_side != side) continue;
    const EdgeCrossings& list = crossed.edges.at(crossing.edge);
    if (list.first != static_cast<Index>(c) || list.winding_change == 0) continue;
    const std::array<Index, 2>& ends = surface.edge(crossing.edge);
    label_vertex(found, labelled, ends[0], list.winding_change > 0 ? kOutside : kInside);
    label_vertex(found, labelled, ends[1], list.winding_change > 0 ? kInside : kOutside);
  }
  for (const Index v : labelled) {
    for (const Index face : surface.vertex_faces[v]) {
      if (crossed.is_intersected.contains(face)) continue;
      std::uint8_t& bits = scratch.set_labels[static_cast<std::size_t>(set_of(scratch, surface, crossed, face))];
      bits = static_cast<std::uint8_t>(bits | found.label[v]);
    }
  }
  bool ambiguous = false;
  for (std::size_t set = 0; set < scratch.face_sets.size(); ++set) {
    const std::uint8_t bits = scratch.set_labels[set];
    const auto [begin, end] = scratch.face_sets[set];
    if (bits == (kInside | kOutside)) {
      ambiguous = true;
      continue;
    }
    for (Index i = begin; i < end; ++i) {
      const Index face = scratch.set_faces[static_cast<std::size_t>(i)];
      if (bits == kInside) found.inner.push_back(face);
      for (const Index v : surface.face(face)) label_vertex(found, labelled, v, static_cast<Label>(bits));
    }
  }
  return ambiguous;
}

}  // namespace pcm::fast
