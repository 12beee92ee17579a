// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/generate/solid_moments.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"

namespace pcm::generate {
namespace {

TEST(SolidMoments, BoxAwayFromTheOriginHasTheTextbookTensor) {
  const SolidMoments solid = solid_moments(box(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(2, 4, 6)));
  EXPECT_NEAR(solid.volume, 6, 1e-13);
  EXPECT_TRUE(solid.centroid.isApprox(Eigen::Vector3d(1.5, 3, 4.5), 1e-14));
  const Eigen::Vector3d expected(4 + 9, 1 + 9, 1 + 4);
  EXPECT_TRUE(solid.unit_inertia.isApprox(Eigen::Matrix3d(expected.asDiagonal()) / 12, 1e-12)) << solid.unit_inertia;
}

TEST(SolidMoments, TurnedBoxHasTheTurnedTensor) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  TriangleMesh mesh = box(Eigen::Vector3d(1, 2, 3));
  const Eigen::Matrix3d unturned = solid_moments(mesh).unit_inertia;
  for (Eigen::Vector3d& p : mesh.vertices) p = turn * p + Eigen::Vector3d(0.3, -2, 1);
  EXPECT_TRUE(solid_moments(mesh).unit_inertia.isApprox(turn * unturned * turn.transpose(), 1e-12));
}

TEST(SolidMoments, FineSphereHasTwoFifthsOfTheRadiusSquared) {
  const SolidMoments solid = solid_moments(icosphere(0.5, 5));
  EXPECT_NEAR(solid.unit_inertia(0, 0), 0.4 * 0.25, 1e-4);
  EXPECT_NEAR(solid.unit_inertia(0, 1), 0, 1e-12);
}

}  // namespace
}  // namespace pcm::generate
