// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

namespace pcm::compare {

/// A rotation from an integer quaternion (w, x, y, z): every entry the rounded quotient of two integers, the same on
/// every machine.
inline Eigen::Matrix3d rotation_of(const std::array<int, 4>& q) {
  const auto [w, x, y, z] = q;
  const double square = w * w + x * x + y * y + z * z;
  Eigen::Matrix3d R;
  R << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return R / square;
}

}  // namespace pcm::compare
