// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The stratum extreme: poses of the other strata between surfaces that are extreme themselves (extreme_meshes.h).
#include <limits>

#include "compare/poses/strata.h"

namespace pcm::compare::detail {
namespace {

/// Components of r that are 0 become up to 8 times the least denormal number, or -0.
void move_by_denormals(PoseRandom& random, DrawnPose& drawn) {
  for (double& r : drawn.pose.r) {
    const std::uint64_t steps = random.below(9);
    const double sign = random.coin() ? 1 : -1;
    if (r == 0) r = sign * (static_cast<double>(steps) * std::numeric_limits<double>::denorm_min());
  }
  drawn.exact = false;
}

}  // namespace

DrawnPose draw_extreme(const FeaturePair& pair, PoseRandom& random) {
  switch (random.below(8)) {
    case 0:
      return draw_overlapping(pair, 1e-6, 0.5, random);
    case 1:
      return draw_overlapping(pair, 1e-15, 1e-6, random);
    case 2:
    case 3:
      return draw_drifted(pair, random);
    case 4: {
      DrawnPose drawn = draw_degenerate(pair, random);
      move_by_ulps(pair, random, drawn);
      return drawn;
    }
    case 5: {
      DrawnPose drawn = draw_degenerate(pair, random);
      move_by_denormals(random, drawn);
      return drawn;
    }
    default:
      return draw_degenerate(pair, random);
  }
}

}  // namespace pcm::compare::detail
