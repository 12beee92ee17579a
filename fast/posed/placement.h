// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "fast/base/geometry.h"
#include "fast/surface/prepared_surface.h"
#include "pcm/inputs.h"

namespace pcm::fast {

/// How far, relative to the greatest coordinate M in Me, anything that box tests compare may be off its value on the
/// rounded problem, u = 2^-53. A vertex of F is a sum of four terms, four roundings deep: off A x_F + r by at most
/// gamma_4 M' where M' <= M is the sum of their absolute values. A box centre taken to Me: gamma_5 M and half an ulp of
/// its own. A difference of two centres: 2 M at most, off by 16 u M. Turned by A^T (entries at most 1 + 1e-9, three of
/// them): off by 3 * 16 u M + 3 * 2 u * 2 M < 64 u M. Rays: their origin and their direction taken over a length of 8 M
/// are each off by less than 64 u M. All of them together stay below 256 u M.
inline constexpr double kPlacementError = 256 * 0x1p-53;

/// A pose with what box tests need to stay conservative on the rounded problem. Scaling all lengths by 2^k scales
/// everything here exactly.
struct Placement {
  Eigen::Matrix3d A;            ///< A_MeMf
  Eigen::Vector3d r_Me;         ///< r_MeMf
  Eigen::Matrix3d A_absolute;   ///< entries of A without their signs
  double max_coordinate = 0;    ///< M: no |coordinate| in Me of E, of F or of r exceeds it, m
  double position_error_E = 0;  ///< error of points and boxes in Me, m
  double position_error_F = 0;  ///< the same in Mf, where A^T stands for the inverse of A, m
  /// How far F's rounded vertices may be from those of its own frame, seen from there, m. They are off A x_F + r by
  /// gamma_4 M along each axis of Me, so by 7 u M along each of Mf and 12.2 u M in all; the skew, computed to 4 u,
  /// counts as in position_error_F.
  double vertex_error_F = 0;
  double skew = 0;  ///< |A^T A - I|, entry by entry, at most
  /// No two vertices of either are farther apart along an axis of Me, if the root boxes touch, m. It is the sum of all
  /// widths in Me and Mf. With root boxes apart by up to a quarter of it along each axis (TrackedPairs) no product of
  /// distances along x, along y and along z exceeds its cube: their sum is at most sqrt(3) + 3/4 of it.
  double extent = 0;

  Placement() = default;
  Placement(const PreparedSurface& surface_E, const PreparedSurface& surface_F, const Pose& pose)
      : Placement(surface_E, surface_F, pose, orthogonality_error(pose.A)) {}
  /// Where the pose's orthogonality error is known.
  Placement(const PreparedSurface& surface_E, const PreparedSurface& surface_F, const Pose& pose,
            double known_orthogonality_error)
      : A(pose.A), r_Me(pose.r), A_absolute(pose.A.cwiseAbs()), skew(known_orthogonality_error) {
    const Eigen::Vector3d max_coordinates_F = A_absolute * surface_F.max_coordinates + pose.r.cwiseAbs();
    max_coordinate = std::max(max_coordinates_F.maxCoeff(), surface_E.max_coordinates.maxCoeff());
    position_error_E = kPlacementError * max_coordinate;
    // Three entries of A^T A - I meet a point's coordinates, or a box's half widths.
    position_error_F = 4 * position_error_E + 12 * skew * surface_F.max_coordinates.maxCoeff();
    vertex_error_F = 16 * 0x1p-53 * max_coordinate + 12 * (skew + 4 * 0x1p-53) * surface_F.max_coordinates.maxCoeff();
    extent = 2 * (1 + 0x1p-20) * (surface_E.tree.root().box.half.sum() + surface_F.tree.root().box.half.sum()) +
             2 * position_error_E;
  }

  /// The exact problem's lines along the normals of F's faces are lines of F's own frame that deviate from the normals
  /// there by no more than this times the depth, for small skews: with A^T A = I + K their direction is (I + K)^-1 n,
  /// and |K| is at most three times its greatest entry, which is computed to 4 u.
  double greatest_lean() const { return 3.01 * (skew + 4 * 0x1p-53); }

  double position_error(Side side) const { return side == Side::E ? position_error_E : position_error_F; }
  /// How far a side's vertices may be from those of its own frame, m: E's are where they are.
  double vertex_error(Side side) const { return side == Side::E ? 0 : vertex_error_F; }

  /// A point given in Me, in the frame of a side's surface: off by at most position_error(side) for points within 4 M.
  Eigen::Vector3d to_frame_of(Side side, const Eigen::Vector3d& x_Me) const {
    return side == Side::E ? x_Me : Eigen::Vector3d(A.transpose() * (x_Me - r_Me));
  }
  /// A direction given in Me, in the frame of a side's surface.
  Eigen::Vector3d direction_in_frame_of(Side side, const Eigen::Vector3d& d_Me) const {
    return side == Side::E ? d_Me : Eigen::Vector3d(A.transpose() * d_Me);
  }
  /// The inverse of to_frame_of, rounded.
  Eigen::Vector3d from_frame_of(Side side, const Eigen::Vector3d& x) const {
    return side == Side::E ? x : Eigen::Vector3d(A * x + r_Me);
  }
};

/// False only where the boxes of E and F, grown by the position error and the margin, m, are apart along one of the six
/// axes of the two frames; true for every pair of boxes that contain touching faces of the rounded problem. Closed
/// tests. At most 36 multiplications and additions of numbers that depend on both boxes.
inline bool boxes_may_touch(const Placement& placement, const Box& box_E, const Box& box_F, double margin = 0) {
  const Eigen::Matrix3d& A = placement.A;
  const Eigen::Matrix3d& B = placement.A_absolute;
  double t[3];
  for (int k = 0; k < 3; ++k) {
    t[k] = A(k, 0) * box_F.centre[0] + A(k, 1) * box_F.centre[1] + A(k, 2) * box_F.centre[2] + placement.r_Me[k] -
           box_E.centre[k];
    const double width = B(k, 0) * box_F.half[0] + B(k, 1) * box_F.half[1] + B(k, 2) * box_F.half[2];
    if (std::abs(t[k]) > box_E.half[k] + width + (placement.position_error_E + margin)) return false;
  }
  for (int k = 0; k < 3; ++k) {
    const double distance = std::abs(A(0, k) * t[0] + A(1, k) * t[1] + A(2, k) * t[2]);
    const double width = B(0, k) * box_E.half[0] + B(1, k) * box_E.half[1] + B(2, k) * box_E.half[2];
    if (distance > box_F.half[k] + width + (placement.position_error_F + margin)) return false;
  }
  return true;
}

}  // namespace pcm::fast
