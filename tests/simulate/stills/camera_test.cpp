// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcm::simulate {
namespace {

/// What is seen of a box, in half heights of the picture from its middle.
Eigen::AlignedBox2d seen(const Eigen::AlignedBox3d& box_W, const Camera& camera) {
  Eigen::AlignedBox2d seen;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d x_C = camera.to_camera(box_W.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    EXPECT_LT(x_C.z(), 0) << "behind the eye";
    seen.extend(Eigen::Vector2d(x_C.x(), x_C.y()) / (-x_C.z() * camera.tan_half_height));
  }
  return seen;
}

TEST(Camera, SeesBoxesWholeInTheMiddleAndAsNearAsTheyFit) {
  for (const double aspect : {0.5, 1.0, 4.0 / 3, 3.0}) {
    for (const Eigen::Vector3d& size :
         {Eigen::Vector3d(2, 2, 0.6), Eigen::Vector3d(0.01, 5, 0), Eigen::Vector3d(0, 0, 3)}) {
      SCOPED_TRACE(testing::Message() << aspect << " of " << size.transpose());
      const Eigen::Vector3d at(3, -20, 7);
      const Eigen::AlignedBox3d box_W(at, at + size);
      const Eigen::AlignedBox2d box = seen(box_W, camera_on(box_W, aspect));
      EXPECT_NEAR(box.center().x(), 0, 0.01);
      EXPECT_NEAR(box.center().y(), 0, 0.01);
      EXPECT_NEAR(std::max(box.max().x() / aspect, box.max().y()), 0.88, 0.01);
    }
  }
}

TEST(Camera, StandsUprightAndLooksFromInFrontFromTheRightAndAbove) {
  const Camera camera = camera_on({Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1)}, 1);
  EXPECT_TRUE((camera.A_CW * camera.A_CW.transpose()).isIdentity(1e-14));
  EXPECT_NEAR(camera.A_CW.determinant(), 1, 1e-14);
  EXPECT_NEAR(camera.A_CW(0, 2), 0, 1e-15) << "W's z is inclined in the picture";
  EXPECT_GT(camera.A_CW(1, 2), 0) << "W's z is upside down";
  EXPECT_GT(camera.eye_W.x(), 0.5);
  EXPECT_LT(camera.eye_W.y(), -1);
  EXPECT_GT(camera.eye_W.z(), 0.5);
  EXPECT_NEAR(camera.distance, camera.eye_W.norm(), 0.2);
  EXPECT_TRUE(camera.to_camera(camera.eye_W).isZero(1e-12));
}

TEST(Camera, LooksAtAPointFromAMetreAway) {
  const Eigen::Vector3d point(4, 5, 6);
  const Camera camera = camera_on({point, point}, 1);
  EXPECT_NEAR((camera.eye_W - point).norm(), 1, 1e-12);
  EXPECT_TRUE(camera.to_camera(point).isApprox(Eigen::Vector3d(0, 0, -1), 1e-12));
}

}  // namespace
}  // namespace pcm::simulate
