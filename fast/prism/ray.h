// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/base/box_tree.h"
#include "fast/base/geometry.h"
#include "pcm/inputs.h"

namespace pcm::fast {

/// A product of two lengths above this, m^2, carries no underflow that counts beside its roundings.
inline constexpr double kLeastProduct = 0x1p-900;

/// How far each component of a face's computed unit normal may be off; infinite where floating point can't tell the
/// normal. Each component of N is a difference of two products of differences: off by at most 4 u times the product of
/// the two edges' lengths; the division by |N| adds a few u. 16 u covers both, short of underflow.
inline double normal_error(const FaceGeometry& face) {
  const double edges = length(face.points_Me[1] - face.points_Me[0]) * length(face.points_Me[2] - face.points_Me[0]);
  const double error = 16 * 0x1p-53 * edges / (2 * face.area);
  return error < 0.125 && face.area > kLeastProduct ? error : std::numeric_limits<double>::infinity();
}

/// A penetration line in floating point, with a bound of its error: what a tree needs to pass by most boxes.
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  ///< unit, -n of the master face
  double direction_error;     ///< of each component; see normal_error

  Ray(const FaceGeometry& face, const Eigen::Vector3d& barycentre)
      : origin(barycentre), direction(-face.n_Me), direction_error(normal_error(face)) {}
};

/// A ray in the frame of a tree; boxes grow by `box_error` before they are tested.
struct TreeRay {
  Eigen::Vector3d origin;
  Eigen::Vector3d inverse;  ///< of the direction's components; those near 0 count as 2^-500, which moves no point
  double box_error;

  TreeRay(const Eigen::Vector3d& ray_origin, const Eigen::Vector3d& direction, double error)
      : origin(ray_origin), box_error(error) {
    for (int k = 0; k < 3; ++k) {
      inverse[k] = 1 / std::copysign(std::max(std::abs(direction[k]), 0x1p-500), direction[k]);
    }
  }

  /// The distance at which the ray enters the grown box, infinite where it misses it.
  double entry(const Box& box) const {
    double first = 0, last = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const double middle = box.centre[k] - origin[k];
      const double width = box.half[k] + box_error;
      const double t0 = (middle - width) * inverse[k], t1 = (middle + width) * inverse[k];
      first = std::max(first, std::min(t0, t1));
      last = std::min(last, std::max(t0, t1));
    }
    return first <= last ? first : std::numeric_limits<double>::infinity();
  }
};

}  // namespace pcm::fast
