// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "fast/base/fast_clear_array.h"
#include "fast/crossings/crossings.h"
#include "fast/posed/posed_pair.h"

namespace pcm::fast {

/// What is known about a vertex with respect to an open surface (PCM section 5), as bits.
enum Label : std::uint8_t { kNoLabel = 0, kInside = 1, kOutside = 2 };

/// What lies inside the other body of one surface (PCM section 5).
struct ActiveFaces {
  std::vector<Index> inner;            ///< uncrossed faces inside the other body, ascending; nested ones included
  std::vector<Index> pockets;          ///< uncrossed faces of negative winding number: the other surface folded over
  FastClearArray<Index> winding;       ///< by vertex of intersected faces: of the other surface where that is closed
  FastClearArray<Index> face_winding;  ///< by face, the same: of inner ones and pockets; marks of intersected ones
  FastClearArray<std::uint8_t> label;  ///< by vertex, Label bits, where the other surface is open
};

/// The active areas of both surfaces but for the intersected faces, which Crossings has.
struct ActiveAreas {
  std::array<ActiveFaces, 2> surfaces;
  bool nested = false;     ///< a component of one lies in the other without crossing
  bool ambiguous = false;  ///< an open surface labels a set of faces both ways

  ActiveFaces& of(Side side) { return surfaces[static_cast<std::size_t>(side)]; }
  const ActiveFaces& of(Side side) const { return surfaces[static_cast<std::size_t>(side)]; }
};

/// Scratch memory of find_active_areas, of a side.
struct ActiveAreaScratch {
  std::vector<Index> nodes;          ///< of the search along a line
  std::vector<Index> stack;          ///< of the floods
  std::vector<Index> flooded;        ///< room for all faces of a surface
  std::vector<std::uint64_t> marks;  ///< of sort_ascending
  FastClearArray<bool> component_crossed;
  // Open other surface: sets of uncrossed faces.
  FastClearArray<Index> set_of_face;
  std::vector<std::pair<Index, Index>> face_sets;  ///< ranges of set_faces
  std::vector<Index> set_faces;
  std::vector<std::uint8_t> set_labels;
};

/// Finds the active areas (PCM section 5). Exact on the rounded problem. The crossings must be listed by edge.
/// Closed other surface: one vertex of each part that the crossings leave undecided is located directly, winding
/// numbers spread from there over the intersected faces' edges and over the inside, never over the outside; a component
/// without crossing is located by one vertex. Cost near the size of the active area, and a box test for each component,
/// in memory that has grown.
/// Open other surface: labels come from crossed edges alone and spread over sets of uncrossed faces, as PCM section 5
/// says; nothing is nested. Cost up to the size of the components touched.
///
/// Where there are many crossings, and threads, one for each side.
void find_active_areas(PosedPair& posed, const Crossings& crossings, PosedTeam& team,
                       std::array<ActiveAreaScratch, 2>& scratch, ActiveAreas& areas);

/// Finds the active area of a side whose other surface is closed; true where a component of it is nested there.
bool find_active_area_in_closed(PosedPair& posed, const Crossings& crossings, Side side, ActiveAreaScratch& scratch,
                                ActiveFaces& found);
/// The same where it is open; true where that labels a set of faces both ways.
bool find_active_area_in_open(const PosedPair& posed, const Crossings& crossings, Side side, ActiveAreaScratch& scratch,
                              ActiveFaces& found);

/// Change of the other surface's winding number along edge k of a face, from its vertex k on.
inline Index winding_change_along(const PreparedSurface& surface, const CrossedSurface& crossed, Index face,
                                  std::size_t k) {
  const Index change = crossed.edges.get(surface.edges_of(face)[k], {}).winding_change;
  return surface.runs_forwards(face, k) ? change : -change;
}

}  // namespace pcm::fast
