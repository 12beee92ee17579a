// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "fast/active/active_areas.h"
#include "fast/crossings/crossings.h"
#include "fast/posed/posed_pair.h"

namespace pcm::fast {

/// What was found of the surfaces at a pose before any force is asked for.
struct Intersection {
  PosedPair& posed;
  const Crossings& crossings;
  const ActiveAreas& active;

  /// Whether a face is active: intersected or inner.
  bool is_active(Side side, Index face) const {
    const auto is_among = [face](const std::vector<Index>& faces) {
      return std::binary_search(faces.begin(), faces.end(), face);
    };
    return is_among(crossings.of(side).intersected) || is_among(active.of(side).inner);
  }
  std::size_t active_faces(Side side) const {
    return crossings.of(side).intersected.size() + active.of(side).inner.size();
  }
};

/// Calls `visit(face)` for the active faces of a side, intersected and inner, in face-index order.
template <class Visit>
void for_each_active_face(const Intersection& intersection, Side side, const Visit& visit) {
  const std::vector<Index>& intersected = intersection.crossings.of(side).intersected;
  const std::vector<Index>& inner = intersection.active.of(side).inner;
  std::size_t i = 0, j = 0;
  while (i < intersected.size() || j < inner.size()) {
    const bool is_inner = i == intersected.size() || (j < inner.size() && inner[j] < intersected[i]);
    visit(is_inner ? inner[j++] : intersected[i++]);
  }
}

}  // namespace pcm::fast
