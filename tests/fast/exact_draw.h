// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "pcm/inputs.h"

/// Questions that are the same in all builds and on all machines.
namespace pcm::fast::test {

/// Draws with correctly rounded operations alone.
class ExactDraw {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
  }
  Eigen::Vector3d vector(double greatest) {
    const double x = between(-greatest, greatest), y = between(-greatest, greatest);
    return {x, y, between(-greatest, greatest)};
  }
  /// From a quaternion within the unit ball.
  Eigen::Matrix3d rotation() {
    for (;;) {
      const double a = between(-1, 1), b = between(-1, 1), c = between(-1, 1), d = between(-1, 1);
      const double square = (a * a + b * b) + (c * c + d * d);
      if (square > 1 || square < 0x1p-6) continue;
      const double k = 2 / square;
      Eigen::Matrix3d A;
      A << 1 - k * (c * c + d * d), k * (b * c - a * d), k * (b * d + a * c),  //
          k * (b * c + a * d), 1 - k * (b * b + d * d), k * (c * d - a * b),   //
          k * (b * d - a * c), k * (c * d + a * b), 1 - k * (b * b + c * c);
      return A;
    }
  }
  /// Multiples of 1/8: features coincide.
  Eigen::Vector3d lattice_vector() {
    Eigen::Vector3d x = vector(8);
    for (double& c : x) c = std::floor(c) / 8;
    return x;
  }

 private:
  std::mt19937_64 random_{2003};
};

struct Law {
  const char* name;
  ContactLaw law;
};

inline std::vector<Law> laws() {
  ContactLaw elastic, whole;
  whole.layers = LayerStiffness{3e6, 2e6};
  whole.damping = 1e4;
  whole.transition_depth = 0x1p-7;
  whole.friction = 0.25;
  whole.slip_velocity = 0.125;
  ContactLaw clamped = whole;
  clamped.max_penetration = 0x1p-5;
  return {{"elastic", elastic}, {"damped, friction", whole}, {"damped, friction, clamped", clamped}};
}

}  // namespace pcm::fast::test
