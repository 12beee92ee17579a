// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/active_areas.h"

#include <limits>

#include "fast/ascending.h"
#include "fast/winding.h"

namespace pcm::fast {

namespace {

/// Change of the winding number along `edge` from its end v to the other one.
Index change_from(const SideState& side, Index edge, Index v) {
  const Index change = side.edge_crossings.get(edge, {}).winding_change;
  return side.surface().edge(edge)[0] == v ? change : -change;
}

/// The winding number of an intersected face's vertex that still waits for its own.
constexpr Index kWaiting = std::numeric_limits<Index>::min();

void settle(SideState& side, std::vector<Index>& stack, Index v, Index winding) {
  side.winding[v] = winding;
  if (winding >= 1) side.inside_vertices.push_back(v);
  stack.push_back(v);
}

/// Spreads the winding number of a located vertex to all that it decides: to waiting vertices, whose edges say by how
/// much it changes, and all over where it is not 0, whose uncrossed faces become inner (or pockets where it is
/// negative, as it can be where the other surface intersects itself). All edges of an uncrossed face are uncrossed, so
/// its vertices share their number; only vertices of intersected faces have other edges to look at.
void spread(SideState& side, std::vector<Index>& stack, Index seed, Index seed_winding) {
  const Surface::Data& surface = side.surface();
  stack.clear();
  settle(side, stack, seed, seed_winding);
  while (!stack.empty()) {
    const Index v = stack.back();
    stack.pop_back();
    const Index winding = side.winding[v];
    bool at_crossings = winding == 0;
    if (winding != 0) {
      for (const Index face : surface.vertex_faces[v]) {
        if (side.is_inner.contains(face)) continue;
        if (side.is_intersected.contains(face)) {
          at_crossings = true;
          continue;
        }
        side.is_inner[face] = true;
        (winding >= 1 ? side.inner : side.pockets).push_back(face);
        for (const Index u : surface.face(face)) {
          if (side.winding.get(u, kWaiting) == kWaiting) settle(side, stack, u, winding);
        }
      }
    }
    if (!at_crossings) continue;
    for (const Index edge : surface.vertex_edges[v]) {
      const Index u = surface.other_end(edge, v);
      if (side.winding.get(u, 0) == kWaiting) settle(side, stack, u, winding + change_from(side, edge, v));
    }
  }
}

/// Components without any crossing whose box reaches into the other surface's.
void find_nested(Workspace::Data& workspace, Side side_name) {
  SideState& side = workspace.side(side_name);
  const Surface::Data& surface = side.surface();
  const Box& other_hull = workspace.side(opposite(side_name)).surface().tree.root().box;
  side.component_crossed.start(surface.component_faces.items());
  for (const Index face : side.intersected) {
    side.component_crossed[surface.face_component[static_cast<std::size_t>(face)]] = true;
  }
  for (std::size_t c = 0; c < surface.component_faces.items(); ++c) {
    if (side.component_crossed.contains(c)) continue;
    const Box& box = surface.component_boxes[c];
    const bool may_be_inside = side_name == Side::E ? boxes_may_touch(workspace.placement, box, other_hull)
                                                    : boxes_may_touch(workspace.placement, other_hull, box);
    if (!may_be_inside) continue;
    const Incidence::Span faces = surface.component_faces[static_cast<Index>(c)];
    const Index winding = winding_about_vertex(workspace, side_name, surface.face(*faces.begin())[0]);
    if (winding == 0) continue;
    for (const Index face : faces) side.winding[surface.face(face)[0]] = winding;
    if (winding >= 1) workspace.contact.nested = true;
    std::vector<Index>& list = winding >= 1 ? side.inner : side.pockets;
    list.insert(list.end(), faces.begin(), faces.end());
  }
}

}  // namespace

void find_active_area_in_closed(Workspace::Data& workspace, Side side_name) {
  SideState& side = workspace.side(side_name);
  const Surface::Data& surface = side.surface();
  side.winding.start(surface.mesh.vertices.size());
  side.is_inner.start(surface.mesh.faces.size());
  for (const Index face : side.intersected) {
    for (const Index v : surface.face(face)) side.winding[v] = kWaiting;
  }
  for (const Index face : side.intersected) {
    for (const Index v : surface.face(face)) {
      if (side.winding[v] != kWaiting) continue;
      spread(side, workspace.stack, v, winding_about_vertex(workspace, side_name, v));
    }
  }
  find_nested(workspace, side_name);
}

void find_active_area(Workspace::Data& workspace, Side side_name) {
  SideState& side = workspace.side(side_name);
  side.inner.clear();
  side.pockets.clear();
  side.inside_vertices.clear();
  if (workspace.side(opposite(side_name)).surface().closed) {
    find_active_area_in_closed(workspace, side_name);
  } else {
    find_active_area_in_open(workspace, side_name);
  }
  sort_ascending(side.inner, workspace.marks);
  sort_ascending(side.pockets, workspace.marks);
}

}  // namespace pcm::fast
