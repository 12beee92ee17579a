// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/seen_faces.h"

#include <algorithm>
#include <cstddef>

#include "fast/clipped/placed_face.h"

namespace pcm::fast {

std::span<const Overlap> overlaps_of(const SeenFaces& seen, const ProjectedFace& face) {
  const auto index = static_cast<std::size_t>(&face - seen.faces.data());
  const auto is_before = [](const Overlap& overlap, std::size_t i) { return overlap.first < i; };
  const auto begin = std::lower_bound(seen.overlaps.begin(), seen.overlaps.end(), index, is_before);
  return {begin, std::lower_bound(begin, seen.overlaps.end(), index + 1, is_before)};
}

void find_visible_pieces(const SeenFaces& seen, std::vector<ConvexPolygon>& pieces,
                         std::vector<ConvexPolygon>& remaining, ClippingError& clipping_error) {
  pieces.assign(1, seen.f.seen);
  const std::span<const Overlap> overlaps = overlaps_of(seen, seen.f);
  if (overlaps.empty()) return;
  const PlacedFace placed_f = placed_face(seen.posed, seen.master, seen.prism, seen.f);
  for (const Overlap& overlap : overlaps) {
    if (pieces.empty()) return;
    const PlacedFace placed_g = placed_face(seen.posed, seen.master, seen.prism, seen.faces[overlap.second]);
    subtract_hidden(placed_f, placed_g, pieces, remaining, clipping_error, seen.posed.work);
  }
  for (const ConvexPolygon& piece : pieces) clipping_error.add_piece(piece, seen.f.seen);
}

}  // namespace pcm::fast
