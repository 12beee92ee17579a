// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/peers/triangle_overlap.h"

#include <gtest/gtest.h>

namespace pcm::compare {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

TEST(TrianglesOverlap, TellsCrossedFromParted) {
  const Corners flat{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  EXPECT_TRUE(triangles_overlap(flat, Corners{{{1, 1, -1}, {1, 1, 1}, {1, 2, 1}}}));
  EXPECT_TRUE(triangles_overlap(Corners{{{1, 1, -1}, {1, 1, 1}, {1, 2, 1}}}, flat));
  EXPECT_TRUE(triangles_overlap(flat, Corners{{{-1, 1, 1}, {1, 1, 0}, {-1, 1, -1}}})) << "a corner in the plane";
  EXPECT_FALSE(triangles_overlap(flat, Corners{{{1, 1, 1}, {2, 1, 1}, {1, 2, 2}}})) << "above";
  EXPECT_FALSE(triangles_overlap(flat, Corners{{{5, 5, -1}, {5, 5, 1}, {6, 5, 1}}})) << "beside";
}

}  // namespace
}  // namespace pcm::compare
