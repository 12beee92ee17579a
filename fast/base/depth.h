// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "fast/base/geometry.h"

namespace pcm::fast {

/// (11): the distance from a face's barycentre C along -n to the plane of a slave face f, u = -height / slope, from
/// differences of vertices only.
struct DepthBelow {
  Eigen::Vector3d N_f;     ///< (f1 - f0) x (f2 - f0), m^2
  Eigen::Vector3d corner;  ///< of f, the one nearest to C, m
  Eigen::Vector3d from_C;  ///< corner - C, m
  double height;           ///< (corner - C) . N_f, m^3
  double slope;            ///< n . N_f, m^2

  DepthBelow(const FaceGeometry& master, const std::array<Eigen::Vector3d, 3>& f)
      : N_f((f[1] - f[0]).cross(f[2] - f[0])),
        corner(f[0]),
        from_C(Eigen::Vector3d::Zero()),
        height(std::numeric_limits<double>::infinity()),
        slope(master.n_Me.dot(N_f)) {
    const auto& p = master.points_Me;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& candidate : f) {
      const Eigen::Vector3d offset = ((candidate - p[0]) + (candidate - p[1]) + (candidate - p[2])) / 3;
      const double square = offset.dot(offset);
      if (square >= nearest) continue;
      nearest = square;
      corner = candidate;
      from_C = offset;
      height = offset.dot(N_f);
    }
  }

  /// u, m; 0 where rounding made it negative or no number.
  double value() const {
    const double depth = -height / slope;
    return std::isfinite(depth) ? std::max(depth, 0.0) : 0;
  }
};

}  // namespace pcm::fast
