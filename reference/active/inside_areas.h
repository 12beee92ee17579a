// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/active/active_areas.h"
#include "reference/crossings/coplanar.h"
#include "reference/lines/face_lines.h"

/// Areas inside the other body, the clipped active areas of PCM section 5: of each face, the integral of the other
/// surface's winding number over it. The face is cut into convex cells about each of which the other surface winds
/// equally often all over (face_cells.h); with N the face's doubled normal and alpha the sum of winding number times
/// area in units of |N|,
///   area = alpha |N|, vector area = alpha N.
///
/// Coplanar faces, other surface closed. A face with a coplanar overlap is looked at from just inside its own body:
/// moved by -s N, s -> 0+, before the tie rule. An overlap with opposite normals then lies outside the other body, one
/// with equal normals inside. So this gives the area without opposite overlaps and with equal ones: E's by the
/// convention; F's is less by the equal ones. All other faces' areas are continuous in the vertices, so the plain tie
/// rule is right for them.
///
/// Coplanar faces, other surface open. It bounds no body, so the convention says nothing; the area is what the tie rule
/// gives. Tilted this way or that, the other surface lies above the face, below it, or ends in it (then the area counts
/// as 0), so any tie rule gives between nothing and the whole face.
namespace pcm::reference {

/// A convex part of a face.
struct InsideCell {
  int winding = 0;                   ///< of the other surface, about all of it; not 0
  std::vector<LineMeeting> corners;  ///< counterclockwise
};

/// A face with its lines as FaceLines numbers them.
struct InsidePart {
  Index face = 0;
  bool has_area = true;               ///< false where rounding left none
  int apex = 0;                       ///< the corner that rays come from
  std::vector<Index> planes;          ///< faces of the other surface along whose planes it is cut
  std::vector<CrossingId> crossings;  ///< that rays go through
  std::vector<InsideCell> cells;      ///< without common area; elsewhere the winding number is 0
  std::vector<Index> overlaps;        ///< its coplanar overlaps, in InsideAreas::overlaps
  bool limited = false;               ///< other surface open: winding numbers are relative, area within [0, face]
};

struct InsideAreas {
  std::vector<CoplanarOverlap> overlaps;
  std::vector<InsidePart> E;  ///< faces with a part inside, or a coplanar overlap, ascending
  std::vector<InsidePart> F;
  Index undefined = 0;  ///< faces a border of the other surface ends in
};

/// `columns_*` as find_active_faces had them.
InsideAreas find_inside_areas(const ExactPose& pose, const std::vector<IndexPair>& candidates,
                              const Crossings& crossings, const ActiveFaces& active_E, const ActiveFaces& active_F,
                              const std::vector<IndexPair>& columns_E, const std::vector<IndexPair>& columns_F);

}  // namespace pcm::reference
