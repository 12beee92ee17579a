// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "meshes/base/floating_point_policy.h"

namespace pcm::fast {

/// The greatest |coordinate| a surface may have, and the least that it must reach, m: between them a volume, the
/// product of three lengths, keeps its digits, and so does every product of two or three that is not a decision, down
/// to details of kLeastDetail, m. Smaller ones may lose depths and areas to underflow, never a decision.
inline constexpr double kGreatestCoordinate = 0x1p300;
inline constexpr double kLeastMaxCoordinate = 0x1p-300;
inline constexpr double kLeastDetail = 0x1p-340;

/// The length of v, correct also where its square would overflow or underflow. Scales exactly with powers of two.
inline double length(const Eigen::Vector3d& v) {
  const double greatest = v.cwiseAbs().maxCoeff();
  // Outside this range squares of coordinates are scaled; inside, scaling would change no bit.
  if (greatest > 0x1p-450 && greatest < 0x1p450) return std::sqrt(v.dot(v));
  if (greatest == 0 || !std::isfinite(greatest)) return greatest;
  const int exponent = std::ilogb(greatest);
  const Eigen::Vector3d w(std::ldexp(v[0], -exponent), std::ldexp(v[1], -exponent), std::ldexp(v[2], -exponent));
  return std::ldexp(std::sqrt(w.dot(w)), exponent);
}

/// The unit vector along v; 0 where v is.
inline Eigen::Vector3d unit(const Eigen::Vector3d& v) {
  const double l = length(v);
  return l > 0 ? Eigen::Vector3d(v / l) : Eigen::Vector3d::Zero();
}

/// What the two products in each component of a x b amount to, all taken absolutely; a and b have none that is
/// negative.
inline Eigen::Vector3d cross_of_magnitudes(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a[1] * b[2] + a[2] * b[1], a[2] * b[0] + a[0] * b[2], a[0] * b[1] + a[1] * b[0]};
}

/// How far A is from a rotation or reflection: max |A^T A - I|, entry by entry, rounded; NaN where a sum in it
/// overflows both ways, so that "at most so much" is false.
inline double orthogonality_error(const Eigen::Matrix3d& A) {
  return (A.transpose() * A - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

/// A face's normal (7) and area (6), from the differences of its vertices in Me. A face whose vertices lie on a line
/// has area 0 and normal 0, never NaN.
struct FaceGeometry {
  std::array<Eigen::Vector3d, 3> points_Me;
  Eigen::Vector3d N_Me;  ///< (p1 - p0) x (p2 - p0), m^2
  Eigen::Vector3d n_Me;  ///< unit outward normal, 0 where N = 0
  double area;           ///< m^2

  explicit FaceGeometry(const std::array<Eigen::Vector3d, 3>& points)
      : FaceGeometry(points, (points[1] - points[0]).cross(points[2] - points[0])) {}
  /// With N as it is known better.
  FaceGeometry(const std::array<Eigen::Vector3d, 3>& points, const Eigen::Vector3d& known_N_Me)
      : points_Me(points), N_Me(known_N_Me) {
    const double twice_area = length(N_Me);
    area = 0.5 * twice_area;
    n_Me = twice_area > 0 ? Eigen::Vector3d(N_Me / twice_area) : Eigen::Vector3d::Zero();
  }

  /// With its normal and area as they were found before.
  FaceGeometry(const std::array<Eigen::Vector3d, 3>& points, const Eigen::Vector3d& known_n_Me, double known_area)
      : points_Me(points),
        N_Me((points[1] - points[0]).cross(points[2] - points[0])),
        n_Me(known_n_Me),
        area(known_area) {}

  /// Barycentre (8), averaged about the first vertex so that only differences are rounded away from it.
  Eigen::Vector3d barycentre_Me() const {
    return points_Me[0] + ((points_Me[1] - points_Me[0]) + (points_Me[2] - points_Me[0])) / 3;
  }
};

}  // namespace pcm::fast
