// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/lines/face_lines.h"
#include "reference/predicates/orientation.h"

/// A face e cut into convex cells by the other surface, and how often that winds about each.
///
/// The cells are polygons of positive area in the face as it is, before any perturbation. From one corner of e, the
/// apex, rays through all crossings cut it into wedges, and each wedge is cut along the segments that pass through it,
/// from ray to ray.
///
/// No face of the other surface passes through the inside of a cell: it passes through e where the tie rule gives them
/// a segment, and as the perturbation vanishes, this tends to the segment between the places of its crossings, on the
/// line in which the planes meet. A crossing has such a place unless its edge q r lies in the plane of its face g.
///  - If g has area, q r does not cross it then. By the tie rule all vertices of E move to one side of that plane (z
///    most, then y, then x) by more, by whatever power, than any vertex of F. So all points of E's feature, being
///    between its vertices, lie on that side of F's where these are one to begin with. The same holds where a face is
///    moved by -s N first.
///  - If g has no area, it is no more than a line, and if that lies in the plane of e, then for the same reason it does
///    not cross e. Otherwise its segment on e tends to a point, and cuts nothing.
namespace pcm::reference {

/// A convex polygon.
struct FaceCell {
  std::vector<Index> bounds;         ///< lines, counterclockwise; every side has positive length
  std::vector<LineMeeting> corners;  ///< corner i: where bound i ends and bound i + 1 begins
  int change = 0;                    ///< the winding number in the cell less that at the apex

  std::size_t size() const { return bounds.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
};

/// Winding numbers are perturbed as `orientation` has it. To be used while the rounding mode is upward.
std::vector<FaceCell> cut_into_cells(const Orientation& orientation, Side side, Index face, FaceLines& lines);

}  // namespace pcm::reference
