// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/lines/convex_pieces.h"

#include <algorithm>
#include <iterator>
#include <optional>
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

/// Where the corners lie: 1 within h, 0 on its line.
std::vector<int> sides_of_corners(MasterPlane& plane, const ConvexPiece& piece, HalfPlane h) {
  std::vector<int> sides;
  for (std::size_t i = 0; i < piece.size(); ++i)
    sides.push_back(plane.side(h, piece.sides[i], piece.sides[piece.next(i)], piece.corners[i]));
  return sides;
}

bool is_among(Index line, const std::vector<HalfPlane>& lines) {
  return std::any_of(lines.begin(), lines.end(), [line](HalfPlane h) { return h.line == line; });
}

/// A piece parted by half-planes: what lies within all of them, and the rest.
struct Parting {
  ConvexPiece within;
  std::vector<ConvexPiece> beyond;
};

Parting part(MasterPlane& plane, const ConvexPiece& piece, const std::vector<HalfPlane>& bounds) {
  Parting parts{piece, {}};
  for (const HalfPlane h : bounds) {
    Halves halves = cut(plane, parts.within, h);
    if (!halves.without.empty()) parts.beyond.push_back(std::move(halves.without));
    parts.within = std::move(halves.within);
    if (parts.within.empty()) break;
  }
  return parts;
}

/// Which side of the piece lies on the line of h, on its far side.
std::optional<std::size_t> side_beyond(MasterPlane& plane, const ConvexPiece& piece, HalfPlane h) {
  const std::vector<int> at = sides_of_corners(plane, piece, h);
  if (*std::max_element(at.begin(), at.end()) > 0) return {};
  for (std::size_t i = 0; i < piece.size(); ++i)
    if (at[i] == 0 && at[piece.next(i)] == 0) return piece.next(i);  // which runs between these corners
  return {};
}

/// A side that is beside the common part of all half-planes, on a line that it may lose, is parted.
template <class MayLose>
std::vector<ConvexPiece> parted_beside(MasterPlane& plane, const ConvexPiece& piece,
                                       const std::vector<HalfPlane>& bounds, const MayLose& may_lose) {
  std::vector<std::optional<std::size_t>> beside;  // by bound
  for (const HalfPlane h : bounds) beside.push_back(side_beyond(plane, piece, h));
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const HalfPlane h = bounds[i];
    if (!beside[i]) continue;
    const Index line = piece.sides[*beside[i]].line;
    if (line == h.line || !may_lose(line)) continue;
    std::vector<HalfPlane> others;
    for (std::size_t k = 0; k < bounds.size(); ++k)
      if (beside[k] != beside[i]) others.push_back(bounds[k]);
    Parting parts = part(plane, piece, others);
    ConvexPiece& inner = parts.within;
    const std::optional<std::size_t> side = inner.empty() ? std::nullopt : side_beyond(plane, inner, h);
    if (!side) continue;
    inner.sides[*side] = opposite(h);
    for (const std::size_t end : {*side == 0 ? inner.size() - 1 : *side - 1, *side})
      inner.corners[end] = plane.corner(inner.sides[end], inner.sides[inner.next(end)]);
    parts.beyond.push_back(std::move(inner));
    return std::move(parts.beyond);
  }
  return {piece};
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
  std::vector<int> sides = sides_of_corners(plane, piece, h);
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
                                  const std::vector<HalfPlane>& bounds, const std::vector<HalfPlane>& kept) {
  std::vector<ConvexPiece> remaining;
  for (const ConvexPiece& piece : pieces) {
    if (plainly_apart(plane, piece, bounds)) {
      remaining.push_back(piece);
      continue;
    }
    Parting parts = part(plane, piece, bounds);
    if (parts.within.empty())
      parts.beyond = parted_beside(plane, piece, bounds, [&](Index line) { return !is_among(line, kept); });
    std::move(parts.beyond.begin(), parts.beyond.end(), std::back_inserter(remaining));
  }
  return remaining;
}

bool may_reach_side(const MasterPlane& plane, const ConvexPiece& piece, HalfPlane side,
                    const std::vector<HalfPlane>& bounds) {
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (piece.sides[i].line != side.line) continue;
    const std::size_t before = i == 0 ? piece.size() - 1 : i - 1;
    const auto is_without = [&](HalfPlane h, std::size_t corner) {
      return plane.quick_side(h, piece.sides[corner], piece.sides[piece.next(corner)], piece.corners[corner]) == -1;
    };
    if (std::none_of(bounds.begin(), bounds.end(),
                     [&](HalfPlane h) { return is_without(h, before) && is_without(h, i); }))
      return true;
  }
  return false;
}

std::vector<ConvexPiece> end_beside(MasterPlane& plane, const std::vector<ConvexPiece>& pieces, HalfPlane side,
                                    const std::vector<HalfPlane>& bounds) {
  std::vector<ConvexPiece> result;
  for (const ConvexPiece& piece : pieces) {
    if (may_reach_side(plane, piece, side, bounds)) {
      std::vector<ConvexPiece> parted =
          parted_beside(plane, piece, bounds, [side](Index line) { return line == side.line; });
      std::move(parted.begin(), parted.end(), std::back_inserter(result));
    } else {
      result.push_back(piece);
    }
  }
  return result;
}

}  // namespace pcm::reference
