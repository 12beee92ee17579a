// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "fast/bounds/uncertain_function.h"
#include "fast/bounds/visible_depth.h"

/// The search by itself, over faces made by hand. Depths are in m; the master is the triangle (0, 0), (1, 0), (0, 1).
namespace pcm::fast {
namespace {

using Point = std::array<double, 2>;
using FlatCorners = std::array<Point, 3>;

/// A slave face, counterclockwise in (s, t), with a depth that is linear there.
struct Face {
  FlatCorners corners;
  LinearDepth depth;
  std::array<Index, 3> vertices;
  int facing = -1;
  double depth_error = 0;
};

LinearDepth level(double depth) {
  return {depth, 0, 0, 0, 0};
}

FaceInView in_view(const Face& face, Index number) {
  FaceInView view;
  FaceEnclosure& f = view.enclosure;
  f.face = number;
  f.of_master = false;
  f.rounding_Me.setZero();
  f.facing = face.facing;
  f.vertices = face.vertices;
  f.greatest = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [s, t] = face.corners[k];
    f.corners[k] = PrismPoint(1 - s - t, s, t, face.depth.at(s, t));
    f.greatest = std::max(f.greatest, face.depth.at(s, t) + face.depth_error);
  }
  f.box = box_of(f.corners.data(), 3).common({0, 1, 0, 1});
  f.position_error = f.cut_error = f.corner_error = {0, 0, 0};
  f.vertex_error = {0, 0, face.depth_error};
  f.rounding = {};
  f.fixed = {};
  f.knows_sides = false;
  f.third_side_error = 0;
  f.depth = face.depth;
  f.field_error = f.line_error = f.depth_error = face.depth_error;
  f.hinge_depth = 0;
  f.only_hangs = false;
  f.sliver = f.relative_rounding = f.crossing_rounding = 0;
  view.may_carry = face.facing <= 0;
  return view;
}

constexpr double kDeep = 1e9;

/// `computed`: a lower bound is looked for where that is positive.
DepthRange search(const std::vector<Face>& faces, double leant = 0, double computed = kDeep) {
  std::vector<FaceInView> sights;
  for (const Face& face : faces) sights.push_back(in_view(face, static_cast<Index>(sights.size())));
  VisibleDepthScratch scratch;
  return find_visible_depth(sights, {leant, leant, leant}, computed, 0, scratch);
}

void expect_depth(const DepthRange& range, double depth) {
  EXPECT_NEAR(range.at_least, depth, 1e-11);
  EXPECT_NEAR(range.at_most, depth, 1e-11);
}

const FlatCorners kAll{{{-4, -4}, {12, -4}, {-4, 12}}};
constexpr double kFloor = 1;  // Depth of a face that all hiders below lie before.

Face floor_everywhere() {
  return {kAll, level(kFloor), {0, 1, 2}};
}

TEST(VisibleDepthSearch, FaceBeforeHalfOfAnotherHidesThatHalf) {
  // The floor falls towards s = 1, and what lies before it covers s > 1/4.
  const Face slope{kAll, {1, 0, 0, 1, 0}, {0, 1, 2}};
  const Face hider{{{{0.25, -8}, {16, 4}, {0.25, 16}}}, level(0.5), {3, 4, 5}};
  expect_depth(search({slope, hider}), 1.25);
  expect_depth(search({slope}), 2);
}

TEST(VisibleDepthSearch, SidesThatTwoHidersShareLeaveNoGap) {
  const std::vector<Face> faces{floor_everywhere(),
                                {{{{0.3, -8}, {20, 4}, {0.35, 16}}}, level(0.5), {3, 4, 5}},
                                {{{{0.3, -8}, {0.35, 16}, {-20, 4}}}, level(0.5), {3, 5, 6}}};
  expect_depth(search(faces), 0.5);
}

TEST(VisibleDepthSearch, GapBetweenTwoHidersShowsTheFloor) {
  for (const double gap : {0x1p-3, 0x1p-20, 0x1p-40}) {
    const std::vector<Face> faces{floor_everywhere(),
                                  {{{{0.3 + gap, -8}, {20, 4}, {0.3 + gap, 16}}}, level(0.5), {3, 4, 5}},
                                  {{{{0.3, -8}, {0.3, 16}, {-20, 4}}}, level(0.5), {6, 7, 8}}};
    expect_depth(search(faces), kFloor);
  }
}

TEST(VisibleDepthSearch, FoldOfTwoFacesThatLookOppositeWaysHidesOnlyOneSide) {
  // They share a side, but both lie on the same side of it.
  const std::vector<Face> faces{floor_everywhere(),
                                {{{{0.3, -8}, {20, 4}, {0.3, 16}}}, level(0.5), {3, 4, 5}, -1},
                                {{{{0.3, -8}, {20, 5}, {0.3, 16}}}, level(0.25), {3, 6, 5}, 1}};
  EXPECT_NEAR(search(faces).at_most, kFloor, 1e-11);
}

TEST(VisibleDepthSearch, FacesThatPassThroughEachOtherAreSeenWhereEachLiesBefore) {
  // Both are 1/2 deep at s = 1/2; the lesser of the two depths is greatest there.
  const Face rising{kAll, {0.75, 0, 0, -0.5, 0}, {0, 1, 2}}, falling{kAll, {0.25, 0, 0, 0.5, 0}, {3, 4, 5}};
  expect_depth(search({rising, falling}), 0.5);
  expect_depth(search({falling, rising}), 0.5);
}

TEST(VisibleDepthSearch, FacesWhoseOrderIsUnsureBoundTheDepthFromBothSides) {
  const DepthRange range = search({{kAll, level(1), {0, 1, 2}, -1, 0.25}, {kAll, level(1.125), {3, 4, 5}, -1, 0.25}});
  EXPECT_LE(range.at_least, 0.75);
  EXPECT_GE(range.at_most, 1.25);
}

TEST(VisibleDepthSearch, WhatIsMetAboveTheMasterHidesNothing) {
  // At depth 0 along s = 1/2: beyond, where it is deeper, it hides.
  const Face slope{kAll, {1, 0, 0, 1, 0}, {0, 1, 2}}, hider{kAll, {-0.5, 0, 0, 1, 0}, {3, 4, 5}};
  expect_depth(search({slope, hider}), 1.5);
}

TEST(VisibleDepthSearch, FaceSeenEdgewiseLeavesOpenWhatItHides) {
  Face edgewise{{{{0.9, -0.1}, {1.1, 0.1}, {1, 0}}}, level(0.5), {3, 4, 5}, 0};
  const Face slope{kAll, {1, 0, 0, 1, 0}, {0, 1, 2}};
  const DepthRange range = search({slope, edgewise});
  EXPECT_LT(range.at_least, 1.99);
  EXPECT_GT(range.at_least, 1.85);
  EXPECT_NEAR(range.at_most, 2, 1e-11);
}

TEST(VisibleDepthSearch, NearTheMastersSidesNothingIsCertainWhereOtherFacesLean) {
  const Face slope{kAll, {1, 0, 0, 1, 0}, {0, 1, 2}};
  const DepthRange range = search({slope}, 0x1p-4);
  EXPECT_NEAR(range.at_least, 1 + 1 - 2 * 0x1p-4, 1e-6);
  EXPECT_NEAR(range.at_most, 2, 1e-11);
}

TEST(VisibleDepthSearch, BorderBetweenAStripAndTheInteriorOfItsFaceCounts) {
  // The floor ends at s = 1/4; one face covers what is more than 2^-20 within it, nothing the strip beside that.
  const Face floor{{{{0.25, -8}, {20, 4}, {0.25, 16}}}, level(1), {0, 1, 2}};
  for (const double strip : {0x1p-10, 0x1p-20, 0x1p-30, 0x1p-40}) {
    const Face hider{{{{0.25 + strip, -8}, {20, 4}, {0.25 + strip, 16}}}, level(0.5), {3, 4, 5}};
    EXPECT_NEAR(search({floor, hider}).at_most, 1, 1e-11) << strip;
  }
}

TEST(VisibleDepthSearch, WhatManyHidersLeaveUndecidedCountsAsSeen) {
  // Faces that hide all of the floor together, too many to look at: they share no sides, but overlap.
  std::vector<Face> faces{floor_everywhere()};
  const int n = 40;
  Index vertex = 3;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double s = (i - 2.5) / (n - 4), t = (j - 2.5) / (n - 4), width = 2.5 / (n - 4);
      faces.push_back({{{{s, t}, {s + width, t}, {s, t + width}}}, level(0.5), {vertex, vertex + 1, vertex + 2}});
      vertex += 3;
    }
  }
  for (const double computed : {0.0, kDeep}) EXPECT_NEAR(search(faces, 0, computed).at_most, kFloor, 1e-11);
}

TEST(VisibleDepthSearch, PiecesAreCutAsOftenAsRoundingsArePaidForAndNoMore) {
  // Strips that overlap hide all of the floor; what is left of it beyond the first k has been cut k times.
  const auto hidden_by = [](int strips) {
    std::vector<Face> faces{floor_everywhere()};
    for (int k = 0; k < strips; ++k) {
      const double from = (k - 0.1) / strips, to = (k + 1.1) / strips;
      const Index v = 3 + 4 * k;
      faces.push_back({{{{from, -8}, {to, -8}, {to, 40}}}, level(0.5), {v, v + 1, v + 2}});
      faces.push_back({{{{from, -8}, {to, 40}, {from, 40}}}, level(0.5), {v, v + 2, v + 3}});
    }
    return faces;
  };
  EXPECT_NEAR(search(hidden_by(kMostPieceCuts), 0, 0).at_most, 0.5, 1e-11);
  EXPECT_NEAR(search(hidden_by(kMostPieceCuts + 1), 0, 0).at_most, kFloor, 1e-11);
}

// Where the side of a face whose order is unsure ends far away, roundings of where a piece is parted along it are far
// greater than those of the pieces' vertices: none of the slit may be lost between two pieces.
TEST(VisibleDepthSearch, SlitBesideTheLineOfASideThatEndsFarAwayIsNotLost) {
  constexpr double kFar = 0x1p30, kRounding = kFar * kUnitRoundoff;
  std::mt19937_64 random(1);
  SCOPED_TRACE("seed 1");
  const auto between = [&random](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  for (int i = 0; i < 20000; ++i) {
    const double angle = between(0.2, 1.3), s = between(0.2, 0.4), t = between(0.2, 0.4);
    const double way_s = -std::sin(angle), way_t = std::cos(angle);
    const auto at = [&](double along, double across) {
      return Point{s + along * way_s - across * way_t, t + along * way_t + across * way_s};
    };
    const Point a = at(-kFar * between(0.3, 1), 0), b = at(kFar * between(0.3, 1), 0);
    const Face unsure{{a, b, at(0, kFar)}, level(1), {0, 1, 2}, 1, 0.3};
    const double side_s = b[0] - a[0], side_t = b[1] - a[1], length = std::hypot(side_s, side_t);
    // As the search has it: there it parts pieces along the side, which passes the master at (s, t) but for roundings.
    const UncertainFunction side(-side_t, a[0], side_s, a[1], 0,
                                 8 * kUnitRoundoff * (std::abs(side_t * b[0]) + std::abs(side_s * b[1])));
    const double off = side(PrismPoint(0, s, t, 0)) / length;
    const double from = side.parted_at() / length - off + between(-2, 2) * kRounding;
    const double width = kRounding * std::ldexp(1, -1 - i % 6);
    const DepthRange range = search({unsure,
                                     {{at(-16, from + width), at(16, from + width), at(0, 16)}, level(0.5), {3, 4, 5}},
                                     {{at(16, from), at(-16, from), at(0, -16)}, level(0.5), {6, 7, 8}},
                                     {kAll, level(1), {9, 10, 11}}});
    ASSERT_GE(range.at_most, 1) << i;
  }
}

}  // namespace
}  // namespace pcm::fast
