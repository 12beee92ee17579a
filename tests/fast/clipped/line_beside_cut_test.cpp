// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/clipped/line_beside_cut.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace pcm::fast::line_beside_cut_test {
namespace {

constexpr SideLine kCut = 7;
constexpr double kRounding = 0x1p-53;

struct Vertex {
  double s, t, height;
  SideLine line;  ///< of the side that begins there
};

struct CutPolygon {
  ConvexPolygon polygon;
  Heights heights{};

  CutPolygon(std::initializer_list<Vertex> vertices) {
    for (const Vertex& vertex : vertices) {
      heights[static_cast<std::size_t>(polygon.count)] = vertex.height;
      polygon.add({1 - vertex.s - vertex.t, vertex.s, vertex.t, 0}, vertex.line);
    }
  }
  ConvexPolygon outside() const {
    Heights outward = heights;
    for (double& height : outward) height *= -1;
    ConvexPolygon sliver = polygon;
    keep_where_not_negative(sliver, outward, kCut);
    return sliver;
  }
};

TEST(LineBesideCut, IsTheSideAlongTheCut) {
  const CutPolygon cut{{0, 0, -kRounding, 10}, {1, 0, -kRounding, 11}, {1, 1, 1, 12}, {0, 1, 1, 13}};
  EXPECT_EQ(line_beside_cut(cut.outside(), cut.polygon, cut.heights, kCut), 10);
  EXPECT_EQ(line_beside_cut({}, cut.polygon, cut.heights, kCut), 10);
}

TEST(LineBesideCut, IsNotTheCutsOwnThoughThatIsLonger) {
  const CutPolygon cut{{0.1, 0, -0.1, 10}, {0.9, 0, -0.1, 11}, {1, 1, 1, 12}, {0, 1, 1, 13}};
  EXPECT_EQ(line_beside_cut(cut.outside(), cut.polygon, cut.heights, kCut), 10);
}

/// All of the border but that vertex is on the other side.
TEST(LineBesideCut, IsTheSideAlongTheCutThatLeavesOneVertex) {
  const CutPolygon triangle{{0, 1, 1, 10}, {0, 0, -kRounding, 11}, {1, 0, -kRounding, 12}};
  EXPECT_EQ(line_beside_cut({}, triangle.polygon, triangle.heights, kCut), 11);
  const CutPolygon quad{{0, 1, 1, 10}, {0, 0, -kRounding, 11}, {0.1, 0, kRounding / 2, 12}, {1, 0, -kRounding, 13}};
  EXPECT_EQ(line_beside_cut(quad.outside(), quad.polygon, quad.heights, kCut), 12);
}

/// The bottom's ends are on either side, for roundings, and another vertex in the place of one of them: the sliver ends
/// there, a corner without length.
TEST(LineBesideCut, IsTheSideAlongTheCutWhereTheSliverIsButACorner) {
  const CutPolygon cut{
      {0, 0, -kRounding, 9}, {0x1p-60, 0, 0x1p-60, 10}, {1, 0, -kRounding, 11}, {1, 1, 1, 12}, {0, 1, 1, 13}};
  EXPECT_EQ(line_beside_cut(cut.outside(), cut.polygon, cut.heights, kCut), 10);
}

TEST(LineBesideCut, IsTheSliversWhereThatIsMissingOnItsSide) {
  const CutPolygon cut{{0, 0, kRounding, 10}, {1, 0, -0x1p-80, 11}, {1, 1, 1, 12}, {0, 1, 1, 13}};
  ConvexPolygon sliver;
  sliver.add({1, 0, 0, 0}, 21);
  sliver.add({0, 1, 0, 0}, kCut);
  sliver.add({0, 1, 0x1p-50, 0}, 23);
  EXPECT_EQ(line_beside_cut(sliver, cut.polygon, cut.heights, kCut), 21);
}

TEST(LineBesideCut, IsTheCutsOwnWhereNothingHasALength) {
  const CutPolygon cut{{0, 0, -kRounding, 10}, {0, 0, 1, 11}, {0, 0, 1, 12}};
  EXPECT_EQ(line_beside_cut({}, cut.polygon, cut.heights, kCut), kCut);
}

}  // namespace
}  // namespace pcm::fast::line_beside_cut_test
