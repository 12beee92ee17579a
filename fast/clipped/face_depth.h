// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "fast/prism/master_prism.h"

namespace pcm::fast {

/// The depth of a face of the slave over the master's plane, and how it grows as the face moves; 0 where roundings
/// leave nothing of the angle between them.
struct FaceDepth {
  Eigen::Vector3d by_motion_Me;  ///< N_h / (n_k . N_h)
  double per_s, per_t;           ///< m

  FaceDepth(const std::array<Eigen::Vector3d, 3>& points_Me, const MasterPrism& prism) {
    const Eigen::Vector3d N = (points_Me[1] - points_Me[0]).cross(points_Me[2] - points_Me[0]);
    by_motion_Me = N / -N.dot(prism.face().n_Me);
    if (!by_motion_Me.allFinite()) by_motion_Me.setZero();
    per_s = -by_motion_Me.dot(prism.edge_s_Me());
    per_t = -by_motion_Me.dot(prism.edge_t_Me());
  }
};

/// With which factor the side from a to b lies along the line on which a linear function is 0, turned by a right angle
/// from its gradient.
inline double along_level(const PrismPoint& a, const PrismPoint& b, double per_s, double per_t) {
  return std::abs(per_s) >= std::abs(per_t) ? (b[kT] - a[kT]) / per_s : (a[kS] - b[kS]) / per_t;
}

}  // namespace pcm::fast
