// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/feature_pose.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "compare/stability/exact_contact.h"

namespace pcm::compare::stability {
namespace {

TEST(FeaturePose, IsAFunctionOfItsRandomNumbers) {
  const SweptBodies bodies = bodies_at({Sweep::depth, -10});
  const Pose a = draw_feature_pose(bodies, PoseRandom(1, 2, 3, 4)),
             b = draw_feature_pose(bodies, PoseRandom(1, 2, 3, 4));
  EXPECT_EQ(a.A, b.A);
  EXPECT_EQ(a.r, b.r);
  EXPECT_NE(a.r, draw_feature_pose(bodies, PoseRandom(1, 2, 3, 5)).r);
}

TEST(FeaturePose, OrientationIsARotation) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Pose pose = draw_feature_pose(bodies_at({Sweep::vertex, -10}), PoseRandom(1, 0, 0, i));
    EXPECT_LT((pose.A.transpose() * pose.A - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_GT(pose.A.determinant(), 0);
  }
}

/// What the bodies say is the exact depth to an ulp of r, also where that is no more than some ulps itself.
void expect_depths(Sweep sweep, int step, Scheme scheme, double least, double greatest) {
  const SweptBodies bodies = bodies_at({sweep, step});
  const ExactBodies exact(bodies.E, bodies.F);
  for (std::uint64_t i = 0; i < 20; ++i) {
    ExactContact contact(exact, draw_feature_pose(bodies, PoseRandom(1, 0, 0, i)), scheme);
    const double depth = contact.sizes()[static_cast<std::size_t>(Quantity::penetration)] / bodies.depth;
    EXPECT_GE(depth, least) << i;
    EXPECT_LE(depth, greatest) << i;
  }
}

TEST(FeaturePose, BarycentreOfOneFaceLiesAsDeepAsSaid) {
  expect_depths(Sweep::depth, -20, Scheme::barycentric, 1 - 1e-9, 1 + 1e-9);
  expect_depths(Sweep::depth, -40, Scheme::barycentric, 1 - 1e-3, 1 + 1e-3);
}

TEST(FeaturePose, FacesLieAboutThatDeepAllOver) {
  expect_depths(Sweep::depth, -20, Scheme::clipped, 1, 2);
}

TEST(FeaturePose, DrawnVertexIsWhatLiesDeepest) {
  expect_depths(Sweep::vertex, -20, Scheme::clipped, 1 - 1e-9, 1 + 1e-9);
  expect_depths(Sweep::vertex, -48, Scheme::clipped, 0.5, 1.5);
}

}  // namespace
}  // namespace pcm::compare::stability
