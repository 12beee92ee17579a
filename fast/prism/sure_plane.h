// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>

#include "fast/predicates/orientation.h"
#include "fast/prism/exact_plane.h"
#include "pcm/work_counters.h"

namespace pcm::fast {

/// A vertex's height over the plane of a face, N . (x - p0), places lines: where a face passes through the master's
/// plane, and where two faces pass through each other. It is computed exactly where it is less than this part of what
/// its terms add up to, so it is always sure to this part of itself, besides a few ulps. Between corners at heights a >
/// 0 > -b the line lies at a / (a + b) of the way, which is off by at most half of that part, however flat the faces
/// lie to each other: where they meet at an angle whose sine is greater than about kExactHeight, by what roundings of
/// the corners' places make, over that sine; where they lie flatter, by no more than kHeightError of the face's size.
/// Of faces in no special place one height in some 2^12 is computed exactly.
inline constexpr double kExactHeight = 0x1p-12;
inline constexpr double kHeightError = kFilterRelative / kExactHeight;

/// Numbers so small are sure to no part of themselves where they are products, for an ulp of a number that underflows
/// is all of it: heights, m^3, and depths, m. Only their signs are right then.
inline constexpr double kUnderflown = kFilterUnderflow;

/// The plane of a face (p0, p1, p2), and sure heights over it: N . (x - p0) with N = (p1 - p0) x (p2 - p0), m^3, is
/// positive where x is above the plane and 0 where it lies in it, exactly; off by no more than kHeightError of itself,
/// besides a few ulps, where it is no less than kUnderflown.
///
/// For one thread: it keeps what it computed exactly.
class SurePlane {
 public:
  explicit SurePlane(const std::array<Eigen::Vector3d, 3>& p);

  double height(const Eigen::Vector3d& x, WorkCounters& work) { return sure_height(N_.dot(x - p_[0]), x, work); }
  /// The height of x that was computed as `height`, and exactly where that would not be sure: it is the determinant of
  /// orient3d(p0, p1, p2, x), term by term, and so is the bound of its error, kFilterRelative of the magnitude.
  double sure_height(double height, const Eigen::Vector3d& x, WorkCounters& work) {
    const double magnitude = N_magnitude_.dot((x - p_[0]).cwiseAbs());
    ++work.predicates;
    if (std::abs(height) > kExactHeight * (magnitude + kFilterUnderflow)) return height;
    ++work.exact_predicates;
    return exact().height(x);
  }
  /// Heights of three points, the same multiple of each, so that the greatest does not underflow.
  ScaledHeights scaled_heights(const std::array<Eigen::Vector3d, 3>& x) { return exact().heights(x); }

 private:
  const ExactPlane& exact();

  std::array<Eigen::Vector3d, 3> p_;
  Eigen::Vector3d N_, N_magnitude_;  ///< N, and with every term taken absolutely, m^2
  std::optional<ExactPlane> exact_;  ///< once a height was not sure
};

}  // namespace pcm::fast
