// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "fast/prism/convex_polygon.h"

namespace pcm::fast {

/// A box in (s, t).
struct BoxST {
  double low_s, high_s, low_t, high_t;

  bool empty() const { return !(low_s <= high_s && low_t <= high_t); }
  double width_s() const { return high_s - low_s; }
  double width_t() const { return high_t - low_t; }
  double area() const { return width_s() * width_t(); }
  BoxST common(const BoxST& other) const {
    return {std::max(low_s, other.low_s), std::min(high_s, other.high_s), std::max(low_t, other.low_t),
            std::min(high_t, other.high_t)};
  }
};

/// The least one that has these points.
inline BoxST box_of(const PrismPoint* points, int count) {
  BoxST box{points[0][kS], points[0][kS], points[0][kT], points[0][kT]};
  for (int i = 1; i < count; ++i) {
    const PrismPoint& x = points[i];
    box.low_s = std::min(box.low_s, x[kS]);
    box.high_s = std::max(box.high_s, x[kS]);
    box.low_t = std::min(box.low_t, x[kT]);
    box.high_t = std::max(box.high_t, x[kT]);
  }
  return box;
}

/// The area within the box that the border of a convex polygon, shifted by up to (s, t) either way, may pass over.
inline double strip_along_border(const BoxST& box, double s, double t) {
  return std::min(box.area(), area_passed_by_border(box.width_s(), box.width_t(), s, t));
}

}  // namespace pcm::fast
