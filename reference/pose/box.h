// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace pcm::reference {

/// An axis-aligned box. Boxes are closed.
struct Box {
  Eigen::Vector3d lower;
  Eigen::Vector3d upper;
  bool meets(const Box& b) const {
    return (lower.array() <= b.upper.array() && b.lower.array() <= upper.array()).all();
  }
  void include(const Box& b) {
    lower = lower.cwiseMin(b.lower);
    upper = upper.cwiseMax(b.upper);
  }
};

}  // namespace pcm::reference
