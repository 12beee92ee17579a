// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "fast/base/geometry.h"
#include "fast/posed/placement.h"
#include "fast/surface/prepared_surface.h"
#include "pcm/inputs.h"

namespace pcm::fast {

/// Covers the roundings of a norm, and that a rotation's columns are unit vectors to 1e-9 only.
inline constexpr double kShorter = 1 - 0x1p-28;
inline constexpr double kLonger = 1 + 0x1p-28;

/// A ball about all points of a surface, in the surface's frame.
struct BoundingBall {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< m
  double radius = 0;                                 ///< m

  BoundingBall() = default;
  explicit BoundingBall(const PreparedSurface& surface)
      : centre(surface.tree.root().box.centre), radius(kLonger * length(surface.tree.root().box.half)) {
    // Half widths are rounded to nearest, beside the last bit of the greatest coordinate.
    radius += 4 * 0x1p-53 * surface.max_coordinates.sum();
  }
  BoundingBall(const Eigen::Vector3d& c, double r) : centre(c), radius(r) {}
};

/// About all points of a box, which is given by its corners.
inline BoundingBall ball_about(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  // Halves are exact; their sum and their difference are rounded.
  return {0.5 * low + 0.5 * high,
          kLonger * (length(0.5 * high - 0.5 * low) + 4 * 0x1p-53 * (low.cwiseAbs() + high.cwiseAbs()).sum())};
}

/// No |coordinate| of r or of A x, x in the ball, exceeds it, m.
inline double norm_bound_of(const Pose& pose, const BoundingBall& ball) {
  return pose.r.cwiseAbs().sum() + 2 * (ball.centre.cwiseAbs().sum() + ball.radius);
}

/// How far points of F within the ball are from where they were at another pose at most, m: with the ball (c, radius)
/// by no more than |(A' - A) c + r' - r| + |A' - A| radius; spectral norms are bounded by Frobenius'. Positions in
/// either pose, and what is computed here, are off by less than kPlacementError M with M the greatest |coordinate|,
/// which the last terms pay for: it holds for rounded vertices as well.
inline double greatest_travel(const Pose& from, const Pose& to, const BoundingBall& ball_F) {
  const Eigen::Matrix3d turn = to.A - from.A;
  const double way = length(turn * ball_F.centre + (to.r - from.r)) + turn.norm() * ball_F.radius;
  return kLonger * (way + kPlacementError * (norm_bound_of(from, ball_F) + norm_bound_of(to, ball_F)));
}

}  // namespace pcm::fast
