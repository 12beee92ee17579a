// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/rotation.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

#include "fast/base/geometry.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

constexpr double kTolerance = 1e-9;

/// Rounding to three digits behind the point changes a number by at most that.
constexpr double kThreeDigits = 5e-4;

/// What that does to a rotation R, entry by entry of D: |(R + D)^T (R + D) - I| <= |R^T D| + |D^T R| + |D^T D|, and a
/// column of R has at most the 1-norm sqrt(3) < 1.7321.
constexpr double kMatrixError = 2 * 1.7321 * kThreeDigits + 3 * kThreeDigits * kThreeDigits;

/// And to the squared norm of a unit quaternion, whose 1-norm is at most 2.
constexpr double kQuaternionError = 2 * 2 * kThreeDigits + 4 * kThreeDigits * kThreeDigits;

[[noreturn]] void refuse_far(const std::string& what, double error, double most) {
  throw BadInput(fmt::format("{}: off by {:.4g}, where rounding to three digits behind the point does {:.4g} at most",
                             what, error, most));
}

}  // namespace

bool is_rotation(const Eigen::Matrix3d& A) {
  return fast::orthogonality_error(A) <= kTolerance && A.determinant() > 0;
}

Rotation rotation_from(const Eigen::Matrix3d& A, bool orthonormalise) {
  if (is_rotation(A)) return {A, 0};
  const double error = fast::orthogonality_error(A);
  if (error <= kMatrixError && A.determinant() < 0)
    throw BadInput(
        "the first nine numbers are a reflection (their determinant is -1), not a rotation; one of the frames is "
        "left-handed, or a row or column has the wrong sign");
  if (!orthonormalise)
    throw BadInput(
        "the first nine numbers are not a rotation to 1e-9; give its rows with all their digits, or add "
        "--orthonormalise");
  if (!(error <= kMatrixError))
    refuse_far("the first nine numbers are too far from a rotation to be orthonormalised", error, kMatrixError);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU() * svd.matrixV().transpose(), error};
}

Rotation rotation_from_quaternion(double w, const Eigen::Vector3d& xyz, bool orthonormalise) {
  const Eigen::Vector4d q(w, xyz[0], xyz[1], xyz[2]);
  const double error = std::abs(q.squaredNorm() - 1);
  const bool is_unit = error <= kTolerance;
  if (!is_unit && !orthonormalise)
    throw BadInput(
        "the first four numbers are not a unit quaternion to 1e-9; give them with all their digits, or add "
        "--orthonormalise");
  if (!(error <= kQuaternionError))
    refuse_far("the first four numbers are too far from a unit quaternion to be normalised", error, kQuaternionError);
  return {Eigen::Quaterniond(w, xyz[0], xyz[1], xyz[2]).normalized().toRotationMatrix(), is_unit ? 0 : error};
}

}  // namespace pcm::compare
