// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/strata.h"

#include <stdexcept>

namespace pcm::compare {
namespace {

/// One pose in four is at rest. Else both velocities are drawn over six orders of magnitude about one size a second,
/// so that damping and friction see either side of their transitions.
Velocity draw_velocity(double size, PoseRandom& random) {
  Velocity velocity;
  if (random.below(4) == 0) return velocity;
  const Eigen::Vector3d along = random.direction();
  velocity.v = along * (random.log_uniform(1e-4, 1e2) * size);
  if (random.coin()) {
    const Eigen::Vector3d about = random.direction();
    velocity.w = about * random.log_uniform(1e-4, 1e2);
  }
  return velocity;
}

}  // namespace

std::string_view name(Stratum stratum) {
  switch (stratum) {
    case Stratum::generic:
      return "generic";
    case Stratum::grazing:
      return "grazing";
    case Stratum::separated:
      return "separated";
    case Stratum::nested:
      return "nested";
    case Stratum::degenerate:
      return "degenerate";
    case Stratum::near_degenerate:
      return "near-degenerate";
    case Stratum::trajectory:
      return "trajectory";
  }
  return "";
}

std::optional<Stratum> stratum_named(std::string_view word) {
  for (const Stratum stratum : kStrata)
    if (name(stratum) == word) return stratum;
  return std::nullopt;
}

DrawnPose draw_pose(Stratum stratum, const FeaturePair& pair, PoseRandom random) {
  DrawnPose drawn;
  switch (stratum) {
    case Stratum::generic:
      drawn = detail::draw_overlapping(pair, 1e-6, 0.5, random);
      break;
    case Stratum::grazing:
      drawn = detail::draw_overlapping(pair, 1e-15, 1e-6, random);
      break;
    case Stratum::separated:
      drawn = detail::draw_separated(pair, random);
      break;
    case Stratum::nested:
      drawn = detail::draw_nested(pair, random);
      break;
    case Stratum::degenerate:
      drawn = detail::draw_degenerate(pair, random);
      break;
    case Stratum::near_degenerate:
      drawn = detail::draw_degenerate(pair, random);
      detail::move_by_ulps(pair, random, drawn);
      break;
    case Stratum::trajectory:
      throw std::logic_error("poses of a trajectory are recorded, not drawn");
  }
  drawn.velocity = draw_velocity(pair.size(), random);
  return drawn;
}

}  // namespace pcm::compare
