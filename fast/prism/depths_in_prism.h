// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "fast/prism/convex_polygon.h"
#include "fast/prism/master_prism.h"

namespace pcm::fast {

/// Between which depths a prism has part of a triangle, m; least > greatest where it has none.
struct DepthsInPrism {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

/// Of a triangle whose corners the prism sees at these, and the prism wider by so much on all sides, m. Above the
/// master face depths are negative.
inline DepthsInPrism depths_in_prism(const MasterPrism& prism, const std::array<PrismPoint, 3>& corners,
                                     double wider_by) {
  ConvexPolygon part;
  for (PrismPoint corner : corners) {
    corner[0] += wider_by * prism.inward_length(1);
    corner[1] += wider_by * prism.inward_length(2);
    corner[2] += wider_by * prism.inward_length(0);
    part.add(corner);
  }
  for (int weight = 0; weight < 3; ++weight) keep_where_not_negative(part, weight);
  DepthsInPrism depths;
  for (int i = 0; i < part.count; ++i) {
    depths.least = std::min(depths.least, part[i][kDepth]);
    depths.greatest = std::max(depths.greatest, part[i][kDepth]);
  }
  return depths;
}

/// Whether the prism's lines may meet the triangle between the master face and a depth, m; prism and depths are wider
/// by `error`.
inline bool may_be_met_before(double depth, const MasterPrism& prism, const std::array<PrismPoint, 3>& corners,
                              double error) {
  const DepthsInPrism depths = depths_in_prism(prism, corners, error);
  return depths.least - error <= depth && depths.greatest + error >= 0;
}

}  // namespace pcm::fast
