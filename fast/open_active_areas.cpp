// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/active_areas.h"

namespace pcm::fast {

namespace {

/// The set of uncrossed faces, connected by edges, that `seed` belongs to; made where it is new.
Index set_of(Workspace::Data& workspace, const SideState& side, Index seed) {
  if (workspace.set_of_face.contains(seed)) return workspace.set_of_face[seed];
  const Surface::Data& surface = side.surface();
  const auto set = static_cast<Index>(workspace.face_sets.size());
  const auto begin = static_cast<Index>(workspace.set_faces.size());
  workspace.set_of_face[seed] = set;
  workspace.set_faces.push_back(seed);
  // The list of the set's faces is its own queue.
  for (std::size_t next = static_cast<std::size_t>(begin); next < workspace.set_faces.size(); ++next) {
    for (const Index face : surface.neighbours_of(workspace.set_faces[next])) {
      if (side.is_intersected.contains(face) || workspace.set_of_face.contains(face)) continue;
      workspace.set_of_face[face] = set;
      workspace.set_faces.push_back(face);
    }
  }
  workspace.face_sets.emplace_back(begin, static_cast<Index>(workspace.set_faces.size()));
  workspace.set_labels.push_back(kNoLabel);
  return set;
}

void label_vertex(SideState& side, std::vector<Index>& labelled, Index v, Label label) {
  std::uint8_t& bits = side.label[v];
  if (bits == kNoLabel) labelled.push_back(v);
  bits = static_cast<std::uint8_t>(bits | label);
}

}  // namespace

void find_active_area_in_open(Workspace::Data& workspace, Side side_name) {
  SideState& side = workspace.side(side_name);
  const Surface::Data& surface = side.surface();
  side.label.start(surface.mesh.vertices.size());
  workspace.set_of_face.start(surface.mesh.faces.size());
  workspace.face_sets.clear();
  workspace.set_faces.clear();
  workspace.set_labels.clear();

  std::vector<Index>& labelled = workspace.stack;
  labelled.clear();
  for (std::size_t c = 0; c < workspace.crossings.size(); ++c) {
    const CrossingNode& crossing = workspace.crossings[c];
    if (crossing.edge_side != side_name) continue;
    const EdgeCrossings& list = side.edge_crossings[crossing.edge];
    if (list.first != static_cast<Index>(c) || list.winding_change == 0) continue;
    const std::array<Index, 2>& ends = surface.edge(crossing.edge);
    label_vertex(side, labelled, ends[0], list.winding_change > 0 ? kOutside : kInside);
    label_vertex(side, labelled, ends[1], list.winding_change > 0 ? kInside : kOutside);
  }
  for (const Index v : labelled) {
    for (const Index face : surface.vertex_faces[v]) {
      if (side.is_intersected.contains(face)) continue;
      std::uint8_t& bits = workspace.set_labels[static_cast<std::size_t>(set_of(workspace, side, face))];
      bits = static_cast<std::uint8_t>(bits | side.label[v]);
    }
  }
  for (std::size_t set = 0; set < workspace.face_sets.size(); ++set) {
    const std::uint8_t bits = workspace.set_labels[set];
    const auto [begin, end] = workspace.face_sets[set];
    if (bits == (kInside | kOutside)) {
      workspace.contact.ambiguous = true;
      continue;
    }
    for (Index i = begin; i < end; ++i) {
      const Index face = workspace.set_faces[static_cast<std::size_t>(i)];
      if (bits == kInside) side.inner.push_back(face);
      for (const Index v : surface.face(face)) label_vertex(side, labelled, v, static_cast<Label>(bits));
    }
  }
}

}  // namespace pcm::fast
