// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/rotation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "compare/poses/poses_file.h"
#include "fast/base/geometry.h"
#include "tests/meshes/expect_bad_input.h"

namespace pcm::compare {
namespace {

/// Every number as it is with so many digits behind the point.
Eigen::Matrix3d rounded(const Eigen::Matrix3d& A, int digits) {
  const double scale = std::pow(10, digits);
  return (A * scale).array().round() / scale;
}

/// Some roundings in each of three products of three terms: U, V and U V^T.
constexpr double kRounding = 0x1p-48;

const Eigen::Matrix3d kTurned = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();

TEST(Rotation, OneThatIsGoodEnoughIsTakenBitForBit) {
  Eigen::Matrix3d A = kTurned;
  A(0, 0) += 1e-10;
  for (const bool orthonormalise : {false, true}) {
    EXPECT_EQ(rotation_from(A, orthonormalise).A, A);
    EXPECT_EQ(rotation_from(A, orthonormalise).replaced_error, 0);
  }
}

TEST(Rotation, FewDigitsAreReplacedByTheNearestRotationOnRequestOnly) {
  for (const int digits : {3, 4, 6, 8}) {
    const Eigen::Matrix3d A = rounded(kTurned, digits);
    expect_bad_input([&] { rotation_from(A, false); }, "digits, or add --orthonormalise");
    const Rotation found = rotation_from(A, true);
    EXPECT_LE(fast::orthogonality_error(found.A), kRounding);
    EXPECT_GT(found.A.determinant(), 0);
    EXPECT_EQ(found.replaced_error, fast::orthogonality_error(A));
    // No rotation turned a little from it is nearer to A, so that the antisymmetric part of R^T A is 0.
    const Eigen::Matrix3d S = found.A.transpose() * A;
    EXPECT_LE((S - S.transpose()).cwiseAbs().maxCoeff(), kRounding);
  }
}

TEST(Rotation, WhatIsFartherThanThreeDigitsIsRefused) {
  expect_bad_input([] { rotation_from(rounded(kTurned, 1), true); }, "too far from a rotation");
  expect_bad_input([] { rotation_from(Eigen::Matrix3d::Zero(), true); }, "too far from a rotation");
  expect_bad_input([] { rotation_from(1e200 * kTurned, true); }, "too far from a rotation");
}

TEST(Rotation, AReflectionIsCalledOne) {
  for (const bool orthonormalise : {false, true}) {
    expect_bad_input([&] { rotation_from(-kTurned, orthonormalise); }, "reflection");
    expect_bad_input([&] { rotation_from(rounded(-kTurned, 6), orthonormalise); }, "reflection");
    expect_bad_input([&] { rotation_from(-2 * kTurned, orthonormalise); }, "rotation");
  }
}

TEST(Rotation, QuaternionsAreThoseOfTheTextbook) {
  const double s = std::sqrt(0.5);
  const Rotation quarter_about_z = rotation_from_quaternion(s, {0, 0, s}, false);
  EXPECT_TRUE(quarter_about_z.A.isApprox(Eigen::Matrix3d{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, kRounding));
  EXPECT_EQ(quarter_about_z.replaced_error, 0);
  EXPECT_TRUE(is_rotation(quarter_about_z.A));
  EXPECT_EQ(rotation_from_quaternion(-1, {0, 0, 0}, false).A, Eigen::Matrix3d::Identity());
  const Eigen::Quaterniond q(kTurned);
  EXPECT_TRUE(rotation_from_quaternion(q.w(), q.vec(), false).A.isApprox(kTurned, kRounding));
}

TEST(Rotation, QuaternionsWithFewDigitsAreNormalisedOnRequest) {
  const Eigen::Vector3d xyz(0, 0, 0.7071);
  expect_bad_input([&] { rotation_from_quaternion(0.7071, xyz, false); },
                   "unit quaternion to 1e-9; give them with all their digits, or add --orthonormalise");
  const Rotation found = rotation_from_quaternion(0.7071, xyz, true);
  EXPECT_LE(fast::orthogonality_error(found.A), kRounding);
  EXPECT_DOUBLE_EQ(found.replaced_error, 1 - 2 * 0.7071 * 0.7071);
  expect_bad_input([] { rotation_from_quaternion(0, {0, 0, 0}, true); }, "too far from a unit quaternion");
  expect_bad_input([] { rotation_from_quaternion(1, {0, 0, 1}, true); }, "too far from a unit quaternion");
}

TEST(PosesFile, BeginsWithAQuaternionWhereThatIsSaid) {
  const PoseReading real_first{OrientationNotation::wxyz, false}, real_last{OrientationNotation::xyzw, false};
  const std::optional<State> a = parse_state("0.6 0 0 0.8  1 2 3  4 5 6  7 8 9", real_first);
  const std::optional<State> b = parse_state("0 0 0.8 0.6  1 2 3  4 5 6  7 8 9", real_last);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->pose.A, b->pose.A);
  EXPECT_NEAR(a->pose.A(1, 0), 2 * 0.6 * 0.8, kRounding);
  EXPECT_EQ(a->pose.r, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(a->velocity.v, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(b->velocity.w, Eigen::Vector3d(7, 8, 9));
  EXPECT_TRUE(parse_state("1 0 0 0 1 2 3", real_first)->velocity.v.isZero(0));
  expect_bad_input([&] { parse_state("1 0 0 0 1 0 0 0 1 1 2 3", real_first); }, "7 (a unit quaternion");
  expect_bad_input([] { parse_state("1 0 0 0 1 2 3"); }, "12 (the rotation A");
}

}  // namespace
}  // namespace pcm::compare
