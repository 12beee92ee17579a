// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

/// Orientations as people write them down.
namespace pcm::compare {

/// Whether max |A^T A - I| <= 1e-9 and det A > 0; false where anything is not finite.
bool is_rotation(const Eigen::Matrix3d& A);

struct Rotation {
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  /// How far what was given is from a rotation, where that was replaced by the nearest one: max |A^T A - I|, of a
  /// quaternion ||q|^2 - 1|. 0 where it was taken as it is.
  double replaced_error = 0;
};

/// A where that is a rotation, bit for bit. Else, with `orthonormalise`, the rotation nearest to it, the orthogonal
/// factor of its polar decomposition, where it may have been rounded to three digits behind the point or more. Throws
/// BadInput for anything else, and says of a reflection that it is one.
Rotation rotation_from(const Eigen::Matrix3d& A, bool orthonormalise);

/// The rotation of a quaternion w + x i + y j + z k, divided by its norm; that is 1 to 1e-9 (its square), or, with
/// `orthonormalise`, by as much as rounding to three digits behind the point may do. Throws BadInput for anything else.
Rotation rotation_from_quaternion(double w, const Eigen::Vector3d& xyz, bool orthonormalise);

}  // namespace pcm::compare
