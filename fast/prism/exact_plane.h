// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <limits>

#include "fast/base/number_vector.h"

namespace pcm::fast {

/// `value`, or where that is 0 and the number of the given sign that it stands for is not, the number next to 0.
inline double keeping_sign(double value, double sign) {
  return value == 0 && sign != 0 ? std::copysign(std::numeric_limits<double>::denorm_min(), sign) : value;
}

/// Heights of three points over the plane of a face: value[k] 2^exponent, the greatest of the values between 2^-64 and
/// 1, but where all are 0.
struct ScaledHeights {
  std::array<double, 3> value{};
  int exponent = 0;
};

/// The plane of a face (p0, p1, p2) in exact numbers: tells heights over it, N . (x - p0) with N = (p1 - p0) x (p2 -
/// p0), all of them 0 where N is. N, most of the work, is computed but once.
class ExactPlane {
 public:
  explicit ExactPlane(const std::array<Eigen::Vector3d, 3>& p);

  /// To a few ulps of itself, but where it underflows; 0 only where it is 0: exact but for the last step. m^3
  double height(const Eigen::Vector3d& x) const;
  ScaledHeights heights(const std::array<Eigen::Vector3d, 3>& x) const;

 private:
  /// Times the cube of the unit.
  Dyadic exact_height(const Eigen::Vector3d& x) const;

  double unit_;         ///< a power of two that lengths are multiplied by, 1 / m
  Eigen::Vector3d p0_;  ///< so multiplied; N by its square
  NumberVector<Dyadic> N_;
};

/// N of a face to a few ulps of itself, component by component, m^2. `size`: a length of the face, > 0.
Eigen::Vector3d exact_normal(const std::array<Eigen::Vector3d, 3>& p, double size);

}  // namespace pcm::fast
