// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/active/active_areas.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "fast/active/winding.h"
#include "fast/base/ascending.h"

namespace pcm::fast {

namespace {

/// What ActiveFaces::face_winding says of an intersected face: before and after its corners' winding numbers are known.
constexpr Index kWaiting = std::numeric_limits<Index>::min();
constexpr Index kDecided = kWaiting + 1;
/// And of an uncrossed face that is not known to be inner or a pocket.
constexpr Index kUnknown = kWaiting + 2;

/// Finds the active area of one side in a closed surface.
class ActiveAreaInClosed {
 public:
  ActiveAreaInClosed(PosedPair& posed, const Crossings& crossings, Side side, ActiveAreaScratch& scratch,
                     ActiveFaces& found)
      : posed_(posed),
        side_(side),
        surface_(posed.surface(side)),
        crossed_(crossings.of(side)),
        scratch_(scratch),
        found_(found) {}

  void find() {
    found_.winding.start(surface_.mesh.vertices.size());
    found_.face_winding.start(surface_.mesh.faces.size());
    for (const Index face : crossed_.intersected) found_.face_winding.set(face, kWaiting);
    for (const Index face : crossed_.intersected) {
      if (found_.face_winding.at(face) != kWaiting) continue;
      locate_corner(face);
      spread(face);
    }
  }
  bool find_nested();

 private:
  void flood(Index seed, Index winding);
  void locate_corner(Index face);
  void decide_corners(Index face);
  void spread(Index seed);

  PosedPair& posed_;
  Side side_;
  const PreparedSurface& surface_;
  const CrossedSurface& crossed_;
  ActiveAreaScratch& scratch_;
  ActiveFaces& found_;
};

/// Enters an uncrossed face and all that its uncrossed neighbours lead to. All their edges are uncrossed, so they share
/// one winding number: they are inner, or pockets where it is negative, as it can be where the other surface intersects
/// itself. Faces entered wait in the order they were found in, and whether a neighbour is new does not branch: a
/// processor could only guess.
void ActiveAreaInClosed::flood(Index seed, Index winding) {
  scratch_.flooded.resize(std::max(scratch_.flooded.size(), surface_.mesh.faces.size() + 1));
  Index* const found = scratch_.flooded.data();
  std::size_t count = 0;
  const auto enter = [&](Index face) {
    found[count] = face;
    count += found_.face_winding.insert(face, winding) ? 1 : 0;
  };
  enter(seed);
  for (std::size_t next = 0; next < count; ++next) {
    for (const Index face : surface_.neighbours_of(found[next])) enter(face);
  }
  std::vector<Index>& list = winding >= 1 ? found_.inner : found_.pockets;
  list.insert(list.end(), found, found + count);
}

/// Locates a corner of an intersected face, unless a neighbour has told its winding number.
void ActiveAreaInClosed::locate_corner(Index face) {
  const Triangle& corners = surface_.face(face);
  for (const Index v : corners) {
    if (found_.winding.contains(v)) return;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Index neighbour = surface_.neighbours_of(face)[k];
    if (crossed_.is_intersected.contains(neighbour) || !found_.face_winding.contains(neighbour)) continue;
    found_.winding.set(corners[k], found_.face_winding.at(neighbour));
    return;
  }
  found_.winding.set(corners[0], winding_about_vertex(posed_, side_, corners[0], scratch_.nodes));
}

/// Carries the winding number from a known corner of an intersected face to the others.
void ActiveAreaInClosed::decide_corners(Index face) {
  const Triangle& corners = surface_.face(face);
  std::size_t k = found_.winding.contains(corners[0]) ? 0 : found_.winding.contains(corners[1]) ? 1 : 2;
  for (int step = 0; step < 2; ++step) {
    const std::size_t next = k == 2 ? 0 : k + 1;
    if (!found_.winding.contains(corners[next])) {
      found_.winding.set(corners[next],
                         found_.winding.at(corners[k]) + winding_change_along(surface_, crossed_, face, k));
    }
    k = next;
  }
}

/// Spreads winding numbers from an intersected face, one of whose corners is located, over the intersected faces that
/// it leads to, edge by edge, and from there over the uncrossed ones where they are not 0.
void ActiveAreaInClosed::spread(Index seed) {
  std::vector<Index>& stack = scratch_.stack;
  stack.assign(1, seed);
  found_.face_winding.set(seed, kDecided);
  while (!stack.empty()) {
    const Index face = stack.back();
    stack.pop_back();
    decide_corners(face);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index neighbour = surface_.neighbours_of(face)[k];
      const Index known = found_.face_winding.get(neighbour, kUnknown);
      if (known == kWaiting) {
        found_.face_winding.set(neighbour, kDecided);
        stack.push_back(neighbour);
      } else if (known == kUnknown) {
        // The edge is uncrossed as the neighbour is.
        const Index winding = found_.winding.at(surface_.face(face)[k]);
        if (winding != 0) flood(neighbour, winding);
      }
    }
  }
}

/// Components without any crossing whose box reaches into the other surface's; true where one of them is inside.
bool ActiveAreaInClosed::find_nested() {
  if (surface_.component_faces.items() == 1 && !crossed_.intersected.empty()) return false;
  const Box& other_root = posed_.surface(opposite(side_)).tree.root().box;
  FastClearArray<bool>& component_crossed = scratch_.component_crossed;
  component_crossed.start(surface_.component_faces.items());
  for (const Index face : crossed_.intersected) {
    component_crossed[surface_.face_component[static_cast<std::size_t>(face)]] = true;
  }
  bool nested = false;
  for (std::size_t c = 0; c < surface_.component_faces.items(); ++c) {
    if (component_crossed.contains(c)) continue;
    const Box& box = surface_.component_boxes[c];
    const bool may_be_inside = side_ == Side::E ? boxes_may_touch(posed_.placement, box, other_root)
                                                : boxes_may_touch(posed_.placement, other_root, box);
    if (!may_be_inside) continue;
    const Incidence::Span faces = surface_.component_faces[static_cast<Index>(c)];
    const Index winding = winding_about_vertex(posed_, side_, surface_.face(*faces.begin())[0], scratch_.nodes);
    if (winding == 0) continue;
    for (const Index face : faces) found_.face_winding.set(face, winding);
    nested = nested || winding >= 1;
    std::vector<Index>& list = winding >= 1 ? found_.inner : found_.pockets;
    list.insert(list.end(), faces.begin(), faces.end());
  }
  return nested;
}

/// More crossings than these go with areas that take threads longer to find than to start.
constexpr std::size_t kEnoughForThreads = 1024;

/// What is to be told of a side beside its faces.
struct SideFindings {
  bool nested = false, ambiguous = false;
};

SideFindings find_active_area(PosedPair& posed, const Crossings& crossings, Side side, ActiveAreaScratch& scratch,
                              ActiveFaces& found) {
  found.inner.clear();
  found.pockets.clear();
  SideFindings findings;
  if (posed.surface(opposite(side)).closed) {
    findings.nested = find_active_area_in_closed(posed, crossings, side, scratch, found);
  } else {
    findings.ambiguous = find_active_area_in_open(posed, crossings, side, scratch, found);
  }
  sort_ascending(found.inner, scratch.marks);
  sort_ascending(found.pockets, scratch.marks);
  return findings;
}

}  // namespace

bool find_active_area_in_closed(PosedPair& posed, const Crossings& crossings, Side side, ActiveAreaScratch& scratch,
                                ActiveFaces& found) {
  ActiveAreaInClosed search(posed, crossings, side, scratch, found);
  search.find();
  return search.find_nested();
}

void find_active_areas(PosedPair& posed, const Crossings& crossings, PosedTeam& team,
                       std::array<ActiveAreaScratch, 2>& scratch, ActiveAreas& areas) {
  std::array<SideFindings, 2> findings;
  const auto find_side = [&](std::size_t side, PosedPair& own_posed) {
    findings[side] =
        find_active_area(own_posed, crossings, static_cast<Side>(side), scratch[side], areas.surfaces[side]);
  };
  if (team.threads() > 1 && crossings.nodes.size() >= kEnoughForThreads) {
    team.run(2, posed, std::cref(find_side));
  } else {
    find_side(0, posed);
    find_side(1, posed);
  }
  areas.nested = findings[0].nested || findings[1].nested;
  areas.ambiguous = findings[0].ambiguous || findings[1].ambiguous;
}

}  // namespace pcm::fast
