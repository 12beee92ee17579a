// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/active_areas.h"

#include <algorithm>
#include <limits>

#include "fast/ascending.h"
#include "fast/winding.h"

namespace pcm::fast {

namespace {

/// What SideState::face_winding says of an intersected face: before and after its corners' winding numbers are known.
constexpr Index kWaiting = std::numeric_limits<Index>::min();
constexpr Index kSettled = kWaiting + 1;
/// And of an uncrossed face that is not known to be inner or a pocket.
constexpr Index kUnknown = kWaiting + 2;

/// Enters an uncrossed face and all that its uncrossed neighbours lead to. All their edges are uncrossed, so they share
/// one winding number: they are inner, or pockets where it is negative, as it can be where the other surface intersects
/// itself. Faces entered wait in the order they were found in, and whether a neighbour is new does not branch: a
/// processor could only guess.
void flood(Workspace::Data& workspace, SideState& side, Index seed, Index winding) {
  const Surface::Data& surface = side.surface();
  workspace.flooded.resize(std::max(workspace.flooded.size(), surface.mesh.faces.size() + 1));
  Index* const found = workspace.flooded.data();
  std::size_t count = 0;
  const auto enter = [&](Index face) {
    found[count] = face;
    count += side.face_winding.insert(face, winding) ? 1 : 0;
  };
  enter(seed);
  for (std::size_t next = 0; next < count; ++next) {
    for (const Index face : surface.neighbours_of(found[next])) enter(face);
  }
  std::vector<Index>& list = winding >= 1 ? side.inner : side.pockets;
  list.insert(list.end(), found, found + count);
}

/// Locates a corner of an intersected face, unless a neighbour has told its winding number.
void locate_corner(Workspace::Data& workspace, Side side_name, Index face) {
  SideState& side = workspace.side(side_name);
  const Triangle& corners = side.surface().face(face);
  for (const Index v : corners) {
    if (side.winding.contains(v)) return;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Index neighbour = side.surface().neighbours_of(face)[k];
    if (side.is_intersected.contains(neighbour) || !side.face_winding.contains(neighbour)) continue;
    side.winding.set(corners[k], side.face_winding.at(neighbour));
    return;
  }
  side.winding.set(corners[0], winding_about_vertex(workspace, side_name, corners[0]));
}

/// Carries the winding number from a known corner of an intersected face to the others.
void settle_corners(SideState& side, Index face) {
  const Triangle& corners = side.surface().face(face);
  std::size_t k = side.winding.contains(corners[0]) ? 0 : side.winding.contains(corners[1]) ? 1 : 2;
  for (int step = 0; step < 2; ++step) {
    const std::size_t next = k == 2 ? 0 : k + 1;
    if (!side.winding.contains(corners[next])) {
      side.winding.set(corners[next], side.winding.at(corners[k]) + winding_change_along(side, face, k));
    }
    k = next;
  }
}

/// Spreads winding numbers from an intersected face, one of whose corners is located, over the intersected faces that
/// it leads to, edge by edge, and from there over the uncrossed ones where they are not 0.
void spread(Workspace::Data& workspace, SideState& side, Index seed) {
  std::vector<Index>& stack = workspace.stack;
  stack.assign(1, seed);
  side.face_winding.set(seed, kSettled);
  while (!stack.empty()) {
    const Index face = stack.back();
    stack.pop_back();
    settle_corners(side, face);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index neighbour = side.surface().neighbours_of(face)[k];
      const Index known = side.face_winding.get(neighbour, kUnknown);
      if (known == kWaiting) {
        side.face_winding.set(neighbour, kSettled);
        stack.push_back(neighbour);
      } else if (known == kUnknown) {
        // The edge is uncrossed as the neighbour is.
        const Index winding = side.winding.at(side.surface().face(face)[k]);
        if (winding != 0) flood(workspace, side, neighbour, winding);
      }
    }
  }
}

/// Components without any crossing whose box reaches into the other surface's.
void find_nested(Workspace::Data& workspace, Side side_name) {
  SideState& side = workspace.side(side_name);
  const Surface::Data& surface = side.surface();
  if (surface.component_faces.items() == 1 && !side.intersected.empty()) return;
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
    for (const Index face : faces) side.face_winding.set(face, winding);
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
  side.face_winding.start(surface.mesh.faces.size());
  for (const Index face : side.intersected) side.face_winding.set(face, kWaiting);
  for (const Index face : side.intersected) {
    if (side.face_winding.at(face) != kWaiting) continue;
    locate_corner(workspace, side_name, face);
    spread(workspace, side, face);
  }
  find_nested(workspace, side_name);
}

void find_active_area(Workspace::Data& workspace, Side side_name) {
  SideState& side = workspace.side(side_name);
  side.inner.clear();
  side.pockets.clear();
  if (workspace.side(opposite(side_name)).surface().closed) {
    find_active_area_in_closed(workspace, side_name);
  } else {
    find_active_area_in_open(workspace, side_name);
  }
  sort_ascending(side.inner, workspace.marks);
  sort_ascending(side.pockets, workspace.marks);
}

}  // namespace pcm::fast
