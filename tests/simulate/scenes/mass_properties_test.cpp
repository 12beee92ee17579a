// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/mass_properties.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "meshes/generate/boxes.h"
#include "tests/meshes/expect_bad_input.h"

namespace pcm::simulate {
namespace {

// 2 m x 3 m x 4 m: volume 24, moments V (b^2 + c^2) / 12; turned and moved, for no frame to be another one.
TEST(SolidOfDensity1, OfATurnedBoxIsThatOfTheBox) {
  const TriangleMesh box = generate::box({1, 1, 1}, {3, 4, 5});
  Placement at;
  at.R = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  at.p = {10, -20, 30};
  const MassProperties solid = solid_of_density_1({{&box, at}});
  EXPECT_NEAR(solid.mass, 24, 1e-12);
  EXPECT_LT((solid.centre_B - (at.R * Eigen::Vector3d(2, 2.5, 3) + at.p)).norm(), 1e-13);
  const Eigen::Matrix3d about_axes = Eigen::Vector3d(24 * 25 / 12.0, 24 * 20 / 12.0, 24 * 13 / 12.0).asDiagonal();
  EXPECT_LT((solid.inertia_B - at.R * about_axes * at.R.transpose()).norm(), 1e-12);
}

TEST(SolidOfDensity1, OfTwoSurfacesIsTheSum) {
  const TriangleMesh left = generate::box({-2, 0, 0}, {-1, 1, 1}), right = generate::box({1, 0, 0}, {2, 1, 1});
  const MassProperties solid = solid_of_density_1({{&left, {}}, {&right, {}}});
  EXPECT_NEAR(solid.mass, 2, 1e-14);
  EXPECT_LT((solid.centre_B - Eigen::Vector3d(0, 0.5, 0.5)).norm(), 1e-14);
  // 1/6 each about its own centre, and 1.5^2 each by Steiner's theorem.
  EXPECT_NEAR(solid.inertia_B(0, 0), 1 / 3.0, 1e-13);
  EXPECT_NEAR(solid.inertia_B(2, 2), 1 / 3.0 + 4.5, 1e-13);
}

TEST(SolidOfDensity1, RefusesWhatHasNoVolume) {
  expect_bad_input([] { solid_of_density_1({}); }, "not positive");
}

TEST(FlawOfInertia, TellsWhatNoBodyHas) {
  const auto flaw = [](double x, double y, double z) { return flaw_of_inertia(Eigen::Vector3d(x, y, z).asDiagonal()); };
  EXPECT_EQ(flaw(1, 1, 2), "");  // a disc
  EXPECT_NE(flaw(1, 1, 2.001), "");
  EXPECT_NE(flaw(1, 1, -1), "");
}

TEST(FlawOfMass, TellsWhatDoublesDoNotHold) {
  const auto flaw = [](double mass, double moment, double centre) {
    return flaw_of_mass({mass, {0, centre, 0}, moment * Eigen::Matrix3d::Identity()});
  };
  EXPECT_EQ(flaw(1, 1, 1), "");
  EXPECT_EQ(flaw(1e-300, 1e-300, 0), "");
  EXPECT_EQ(flaw(1e300, 1e300, 1), "");
  EXPECT_NE(flaw(1e-310, 1, 0), "");
  EXPECT_NE(flaw(1, 1e-310, 0), "");
  EXPECT_NE(flaw(1e-160, 1e160, 0), "");  // their ratio
  EXPECT_NE(flaw(1e160, 1e-160, 0), "");
  EXPECT_NE(flaw(1, 1, 1e160), "");  // Steiner's term
}

}  // namespace
}  // namespace pcm::simulate
