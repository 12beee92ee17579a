// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/arrow.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace pcm::simulate {
namespace {

struct Extent {
  double least_along = 1e9, greatest_along = -1e9, shaft = 0, head = 0;  // m
};

/// Along an arrow that begins at `from`; radii before and behind the neck.
Extent extent_of(const std::vector<std::array<Eigen::Vector3d, 3>>& triangles, const Eigen::Vector3d& from,
                 const Eigen::Vector3d& direction, double neck) {
  Extent extent;
  for (const auto& triangle : triangles) {
    for (const Eigen::Vector3d& x : triangle) {
      const double along = (x - from).dot(direction);
      const double radius = (x - from - along * direction).norm();
      extent.least_along = std::min(extent.least_along, along);
      extent.greatest_along = std::max(extent.greatest_along, along);
      if (along < neck / 2) extent.shaft = std::max(extent.shaft, radius);
      extent.head = std::max(extent.head, radius);
    }
  }
  return extent;
}

TEST(Arrow, ReachesFromEndToEndWithAHeadOfItsWidth) {
  const Eigen::Vector3d from(1, 2, 3), direction = Eigen::Vector3d(1, -2, 2) / 3;
  const Extent extent = extent_of(arrow(from, from + 2 * direction, 0.02), from, direction, 1.88);
  EXPECT_NEAR(extent.least_along, 0, 1e-12);
  EXPECT_NEAR(extent.greatest_along, 2, 1e-12);
  EXPECT_NEAR(extent.shaft, 0.02, 1e-12);
  EXPECT_NEAR(extent.head, 0.044, 1e-12);
}

TEST(Arrow, IsSlimmerWhereItIsShort) {
  const Eigen::Vector3d from(1, 2, 3), direction(0, 0, 1);
  const Extent extent = extent_of(arrow(from, from + 0.05 * direction, 0.02), from, direction, 0.02);
  EXPECT_NEAR(extent.greatest_along, 0.05, 1e-12);
  EXPECT_NEAR(extent.shaft, 0.005, 1e-12);  // a sixth of the head, which is 0.6 of the length
  EXPECT_NEAR(extent.head, 0.011, 1e-12);
}

}  // namespace
}  // namespace pcm::simulate
