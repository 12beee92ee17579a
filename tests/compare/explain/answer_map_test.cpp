// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/answer_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/catalogue.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

AnswerMap map_of(const std::string& name, const MapGrid& grid) {
  const degenerate::Case named = degenerate::find_case(name);
  return answer_map(named.E, named.F, {named.A, named.r}, grid);
}

TEST(AnswerMap, CubeOverCubeTouchesFromTheTieOnToOneSideOnly) {
  // Coordinates and r are multiples of the ulp, so that each cell is the pose it says; x decides, y does not.
  const TriangleMesh cube = generate::box({1, 1, 1});
  MapGrid grid;
  grid.steps = 2;
  const AnswerMap map = answer_map(cube, cube, {Eigen::Matrix3d::Identity(), {1, 0.25, 0.25}}, grid);
  const std::vector<std::size_t>& truth = map.rows.front().answers;
  const auto apart = std::find(map.answers.begin(), map.answers.end(), "no crossing");
  ASSERT_NE(apart, map.answers.end());
  const auto no_crossing = static_cast<std::size_t>(apart - map.answers.begin());
  for (std::size_t up = 0; up < 5; ++up) {
    EXPECT_NE(truth[5 * up], no_crossing) << up;      // two ulps less than a side apart
    EXPECT_EQ(truth[5 * up + 4], no_crossing) << up;  // two ulps more
  }
}

TEST(AnswerMap, EngineIsNowhereWrongAboutAnEdgeThroughAVertexAndThePublishedAlgorithmIsAtTies) {
  MapGrid grid;
  grid.steps = 4;
  const AnswerMap map = map_of("edge_through_vertex", grid);
  ASSERT_EQ(map.rows.size(), 3U);
  EXPECT_EQ(map.rows[0].answers.size(), 81U);
  EXPECT_EQ(map.wrong(map.rows[0]), 0U);
  EXPECT_EQ(map.wrong(map.rows[1]), 0U);
  EXPECT_GT(map.wrong(map.rows[2]), 0U);
  EXPECT_LT(map.wrong(map.rows[2]), 81U);
  EXPECT_GE(map.answers.size(), 4U);
}

TEST(AnswerMap, PictureCrossesOutWhatIsWrongAndNamesEveryAnswerOnce) {
  AnswerMap map;
  map.grid.steps = 1;
  map.grid.ulp = 0x1p-52;
  map.answers = {"no crossing", "6 crossings"};
  map.rows = {{"oracle", std::vector<std::size_t>(9, 0)}, {"fast", std::vector<std::size_t>(9, 0)}};
  EXPECT_EQ(answer_map_svg(map, "title").find("<path"), std::string::npos);
  map.rows[1].answers[4] = 1;
  const std::string picture = answer_map_svg(map, "a < b");
  EXPECT_NE(picture.find("<path"), std::string::npos);
  EXPECT_NE(picture.find("fast: 1 of 9 wrong"), std::string::npos);
  EXPECT_NE(picture.find("2: 6 crossings"), std::string::npos);
  EXPECT_NE(picture.find("a &lt; b"), std::string::npos);
}

TEST(AnswerMap, PoseThatIsNoRotationIsRefused) {
  const TriangleMesh cube = generate::box({1, 1, 1});
  EXPECT_THROW(answer_map(cube, cube, {2 * Eigen::Matrix3d::Identity(), {1, 0, 0}}, MapGrid{}), BadInput);
}

}  // namespace
}  // namespace pcm::compare
