// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/proofs/self_intersections.h"

#include <gtest/gtest.h>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"

namespace pcm::reference {
namespace {

using Pairs = std::vector<std::pair<Index, Index>>;

TEST(SelfIntersections, SoundSurfacesHaveNone) {
  EXPECT_TRUE(self_intersections(generate::gridded_box(1.0, 3)).empty());
  EXPECT_TRUE(self_intersections(generate::icosphere(1, 2)).empty());
  EXPECT_TRUE(self_intersections(generate::bubble()).empty());
}

TEST(SelfIntersections, CrossingTrianglesAreFound) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, -1}, {0.25, 0.25, 1}, {1, 1, 0}},
                          {{0, 1, 2}, {3, 4, 5}},
                          "crossing"};
  EXPECT_EQ(self_intersections(mesh), (Pairs{{0, 1}}));
}

TEST(SelfIntersections, CommonVertexAloneIsNoneAndCrossingThereIsFound) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 1}, {0, -1, 1}}, {{0, 1, 2}, {0, 3, 4}}, "vertex"};
  EXPECT_TRUE(self_intersections(mesh).empty());
  mesh.vertices[3] = {1, 1, 1};
  mesh.vertices[4] = {1, 1, -1};
  EXPECT_EQ(self_intersections(mesh), (Pairs{{0, 1}}));
}

TEST(SelfIntersections, FaceFoldedFlatUponItsNeighbourIsFound) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 0}}, {{0, 1, 2}, {1, 0, 3}}, "fold"};
  EXPECT_EQ(self_intersections(mesh), (Pairs{{0, 1}}));
  mesh.vertices[3] = {0.25, -0.25, 0};
  EXPECT_TRUE(self_intersections(mesh).empty());
}

TEST(SelfIntersections, AFaceWithoutAreaIsFoldedUponNothing) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 3}}, "needle"};
  EXPECT_TRUE(self_intersections(mesh).empty());
}

}  // namespace
}  // namespace pcm::reference
