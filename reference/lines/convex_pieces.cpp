// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/convex_pieces.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace pcm::reference {
namespace {

/// The part of a piece within h, which runs through its interior; `sides[i]`: where corner i lies, 1 within.
ConvexPiece part_within(const MasterPlane& plane, const ConvexPiece& piece, HalfPlane h,
                        const std::vector<int>& sides) {
  ConvexPiece part;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const std::size_t end = piece.next(i);  // side `end` runs from corner i to corner `end`
    if (sides[i] <= 0 && sides[end] <= 0) continue;
    part.sides.push_back(piece.sides[end]);
    if (sides[end] <= 0) part.sides.push_back(h);
  }
  for (std::size_t i = 0; i < part.size(); ++i)
    part.corners.push_back(plane.corner(part.sides[i], part.sides[part.next(i)]));
  return part;
}

}  // namespace

ConvexPiece whole_face(const MasterPlane& plane, const SeenFace& face) {
  const auto [a, b, c] = face.sides;
  // Seen along N, a face that looks the other way is listed clockwise.
  ConvexPiece piece{face.facing > 0 ? std::vector{a, b, c} : std::vector{c, b, a}, {}};
  for (std::size_t i = 0; i < 3; ++i) piece.corners.push_back(plane.corner(piece.sides[i], piece.sides[piece.next(i)]));
  return piece;
}

Halves cut(MasterPlane& plane, const ConvexPiece& piece, HalfPlane h) {
  std::vector<int> sides;
  for (std::size_t i = 0; i < piece.size(); ++i)
    sides.push_back(plane.side(h, piece.sides[i], piece.sides[piece.next(i)], piece.corners[i]));
  const auto [least, greatest] = std::minmax_element(sides.begin(), sides.end());
  if (*least >= 0) return {piece, {}};
  if (*greatest <= 0) return {{}, piece};
  ConvexPiece within = part_within(plane, piece, h, sides);
  for (int& side : sides) side = -side;
  return {std::move(within), part_within(plane, piece, opposite(h), sides)};
}

ConvexPiece clip(MasterPlane& plane, ConvexPiece piece, const std::vector<HalfPlane>& bounds) {
  if (plainly_apart(plane, piece, bounds)) return {};
  for (const HalfPlane h : bounds) {
    piece = cut(plane, piece, h).within;
    if (piece.empty()) break;
  }
  return piece;
}

bool plainly_apart(const MasterPlane& plane, const ConvexPiece& piece, const std::vector<HalfPlane>& bounds) {
  return std::any_of(bounds.begin(), bounds.end(), [&](HalfPlane h) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const auto side = plane.quick_side(h, piece.sides[i], piece.sides[piece.next(i)], piece.corners[i]);
      if (!side || *side > 0) return false;
    }
    return true;
  });
}

std::vector<ConvexPiece> subtract(MasterPlane& plane, const std::vector<ConvexPiece>& pieces,
                                  const std::vector<HalfPlane>& bounds) {
  std::vector<ConvexPiece> remaining;
  for (const ConvexPiece& piece : pieces) {
    if (plainly_apart(plane, piece, bounds)) {
      remaining.push_back(piece);
      continue;
    }
    std::vector<ConvexPiece> beyond;
    ConvexPiece rest = piece;
    for (const HalfPlane h : bounds) {
      Halves halves = cut(plane, rest, h);
      if (!halves.without.empty()) beyond.push_back(std::move(halves.without));
      rest = std::move(halves.within);
      if (rest.empty()) break;
    }
    if (rest.empty())
      remaining.push_back(piece);  // nothing to take out, so it need not be split
    else
      std::move(beyond.begin(), beyond.end(), std::back_inserter(remaining));
  }
  return remaining;
}

}  // namespace pcm::reference
