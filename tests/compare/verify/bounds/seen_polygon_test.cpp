// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/seen_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace pcm::compare {
namespace {

/// A square of side 2 in the plane z = x / 4.
const std::vector<SeenPoint> kSquare = {{-1, -1, -0.25}, {1, -1, 0.25}, {1, 1, 0.25}, {-1, 1, -0.25}};

TEST(SeenPolygon, AreaAndOutlineAreThoseInThePlane) {
  EXPECT_EQ(area_of(kSquare), 4);
  EXPECT_EQ(outline_of(kSquare), 8);
  EXPECT_EQ(area_of({kSquare.rbegin(), kSquare.rend()}), -4);
  EXPECT_EQ(area_of({}), 0);
  EXPECT_EQ(outline_of({}), 0);
  EXPECT_EQ(outline_of({{1, 2, 3}}), 0);
}

TEST(SeenPolygon, CutKeepsWhatIsZero) {
  EXPECT_EQ(cut(kSquare, [](const SeenPoint& x) { return x.x() - 1; }).size(), 2);
  EXPECT_TRUE(cut(kSquare, [](const SeenPoint& x) { return x.x() - 1.5; }).empty());
  const auto half = cut(kSquare, [](const SeenPoint& x) { return x.z(); });
  EXPECT_EQ(area_of(half), 2);
  for (const SeenPoint& x : half) EXPECT_EQ(x.z(), x.x() / 4);
}

/// z is less than the error in a strip as wide as twice that over the slope, and nowhere where it is 0 along a side of
/// no error.
TEST(SeenPolygon, AreaNearZeroIsTheStripWhereTheSignMayBeMistaken) {
  EXPECT_DOUBLE_EQ(area_near_zero(kSquare, 0x1p-10), 2 * (8 * 0x1p-10));
  EXPECT_EQ(area_near_zero(kSquare, 0), 0);
  EXPECT_EQ(area_near_zero(kSquare, 1), 4);
  EXPECT_EQ(area_near_zero(kSquare, std::numeric_limits<double>::infinity()), 4);
  std::vector<SeenPoint> beyond = kSquare;
  for (SeenPoint& x : beyond) x.z() += 0.5;
  EXPECT_EQ(area_near_zero(beyond, 0.125), 0);
}

/// Whichever way the face runs.
TEST(SeenPolygon, WithinAFaceGrownByAMarginReachesThatMuchFarther) {
  const SeenFace face = {SeenPoint(0, 0, 0), SeenPoint(8, 0, 0), SeenPoint(0, 8, 0)};
  const SeenFace reversed = {face[0], face[2], face[1]};
  for (const SeenFace& f : {face, reversed}) {
    EXPECT_EQ(area_of(within(kSquare, f, 0)), 1);
    EXPECT_EQ(area_of(within(kSquare, f, 0.5)), 2.25);
    EXPECT_EQ(area_of(within(kSquare, f, 2)), 4);
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2d inward = inward_of_side(f, k);
      EXPECT_DOUBLE_EQ(inward.norm(), 1);
      EXPECT_GT(inward.dot((f[(k + 2) % 3] - f[k]).head<2>()), 0);
    }
  }
}

TEST(SeenPolygon, ASideWithoutLengthBoundsNothing) {
  const SeenFace needle = {SeenPoint(0, 0, 0), SeenPoint(0, 0, 1), SeenPoint(0, 8, 0)};
  EXPECT_EQ(inward_of_side(needle, 0), Eigen::Vector2d::Zero());
  EXPECT_EQ(area_of(within(kSquare, needle, 0)), 0);
  EXPECT_EQ(area_of(within(kSquare, needle, 0.25)), 1);
}

TEST(SeenPolygon, ASidePartsWhatLiesBeyondItByMoreThanAStrip) {
  const SeenFace face = {SeenPoint(1.5, -8, 0), SeenPoint(1.5, 8, 0), SeenPoint(3, 0, 0)};
  const auto parts = [&](double strip) {
    return some_side_parts(face, strip, [](std::size_t, const auto& is_beyond) {
      return std::all_of(kSquare.begin(), kSquare.end(), is_beyond);
    });
  };
  EXPECT_TRUE(parts(0));
  EXPECT_TRUE(parts(0.25));
  EXPECT_FALSE(parts(0.5));
}

}  // namespace
}  // namespace pcm::compare
