// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "reference/numbers/ball.h"
#include "reference/numbers/vector3.h"

namespace pcm::reference {

/// Of the Balls for what DoubleDouble does not round: enough for nearly all that are no ties.
inline constexpr mpfr_prec_t kRoundingPrecision = 240;

/// Turns enclosures (DoubleDouble, Ball) into correctly rounded doubles and remembers whether it could each time.
class CorrectRounder {
 public:
  template <class T>
  void operator()(const T& value, double& target) {
    if (const std::optional<double> rounded = value.rounded())
      target = *rounded;
    else
      all_ = false;
  }
  template <class T>
  void operator()(const Vec3<T>& value, Eigen::Vector3d& target) {
    for (int i = 0; i < 3; ++i) (*this)(value[i], target[i]);
  }

  bool all() const { return all_; }

 private:
  bool all_ = true;
};

}  // namespace pcm::reference
