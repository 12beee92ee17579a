// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/lines/master_plane.h"

/// Convex polygons in the plane of a master face, exactly: cut in two by a line, taken out of one another.
namespace pcm::reference {

/// A convex polygon of positive area, counterclockwise in (s, t); every side has positive length. Empty: no area.
struct ConvexPiece {
  std::vector<HalfPlane> sides;
  std::vector<Vec3<Interval>> corners;  ///< corner i encloses where side i ends and side i + 1 begins

  bool empty() const { return sides.empty(); }
  std::size_t size() const { return sides.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == sides.size() ? 0 : i + 1; }
};

/// The projection of a face that is not seen edge-on.
ConvexPiece whole_face(const MasterPlane& plane, const SeenFace& face);

/// The parts of a piece on either side of a line.
struct Halves {
  ConvexPiece within, without;
};
Halves cut(MasterPlane& plane, const ConvexPiece& piece, HalfPlane h);

/// What of the piece lies in all the half-planes.
ConvexPiece clip(MasterPlane& plane, ConvexPiece piece, const std::vector<HalfPlane>& bounds);

/// Whether the piece and the common part of all half-planes surely share no area. Cheap; false where that is not plain.
bool plainly_apart(const MasterPlane& plane, const ConvexPiece& piece, const std::vector<HalfPlane>& bounds);

/// What of the pieces lies outside the common part of all half-planes: of each the part beyond the first line, then of
/// the rest the part beyond the second, and so on. Where a piece ends at the common part without losing anything, on a
/// line along which it was cut before, it ends there for that reason: the side is parted where the common part begins
/// and ends, and what is between lies on the half-plane's line. `kept`: lines that no side loses.
std::vector<ConvexPiece> subtract(MasterPlane& plane, const std::vector<ConvexPiece>& pieces,
                                  const std::vector<HalfPlane>& bounds, const std::vector<HalfPlane>& kept);

/// Whether the common part of all half-planes may have points on a side that the piece has on the line of `side`.
/// Cheap; true where that is not plain.
bool may_reach_side(const MasterPlane& plane, const ConvexPiece& piece, HalfPlane side,
                    const std::vector<HalfPlane>& bounds);

/// The same pieces: where one ends on the line of `side` at the common part of all half-planes, which lies beyond, the
/// side is parted as by `subtract`.
std::vector<ConvexPiece> end_beside(MasterPlane& plane, const std::vector<ConvexPiece>& pieces, HalfPlane side,
                                    const std::vector<HalfPlane>& bounds);

}  // namespace pcm::reference
