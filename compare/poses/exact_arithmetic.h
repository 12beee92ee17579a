// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace pcm::compare {

/// A rounded sum with what rounding took off it: a + b = sum + error exactly (Knuth 1969), short of overflow.
struct TwoSum {
  TwoSum(double a, double b) : sum(a + b) {
    const double b_rounded = sum - a;
    error = (a - (sum - b_rounded)) + (b - b_rounded);
  }
  double sum;
  double error = 0;
};

/// Sums and products that remember whether any of them was rounded (by error-free transformation).
class WatchedArithmetic {
 public:
  double plus(double a, double b) {
    const TwoSum both(a, b);
    exact_ = exact_ && both.error == 0;
    return both.sum;
  }
  double times(double a, double b) {
    const double product = a * b;
    // Below that, what is rounded off may underflow.
    const bool is_told = std::abs(product) >= 0x1p-960 || a == 0 || b == 0;
    exact_ = exact_ && is_told && std::fma(a, b, -product) == 0;
    return product;
  }
  Eigen::Vector3d plus(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return {plus(a.x(), b.x()), plus(a.y(), b.y()), plus(a.z(), b.z())};
  }
  Eigen::Vector3d minus(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return plus(a, -b); }
  Eigen::Vector3d times(const Eigen::Vector3d& a, double b) {
    return {times(a.x(), b), times(a.y(), b), times(a.z(), b)};
  }

  /// True as long as no step was rounded.
  bool exact() const { return exact_; }

 private:
  bool exact_ = true;
};

}  // namespace pcm::compare
