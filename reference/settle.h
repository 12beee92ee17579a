// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "reference/ball.h"
#include "reference/vector3.h"

namespace pcm::reference {

/// Turns enclosures into correctly rounded doubles and remembers whether it could each time. At the last precision what
/// is not settled becomes the middle of its enclosure, 0 where that holds 0.
class Settler {
 public:
  explicit Settler(bool last) : last_(last) {}

  void operator()(const Ball& value, double& target) {
    const std::optional<double> rounded = value.rounded();
    all_ = all_ && rounded;
    if (rounded || last_) target = rounded ? *rounded : value.middle();
  }
  void operator()(const Vec3<Ball>& value, Eigen::Vector3d& target) {
    for (int i = 0; i < 3; ++i) (*this)(value[i], target[i]);
  }

  bool all() const { return all_; }

 private:
  bool last_;
  bool all_ = true;
};

}  // namespace pcm::reference
