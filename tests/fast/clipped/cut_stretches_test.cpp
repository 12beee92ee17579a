// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/clipped/cut_stretches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pcm::fast::cut_stretches_test {
namespace {

constexpr Uncertainty kUncertainty{0x1p-48, 0x1p-48};
constexpr EdgeKey kEdge{false, 3, 7};

PrismPoint at(double s, double t) {
  return {1 - s - t, s, t, 0};
}

/// Along t = 1/4, on an edge from s = 0 to 1.
CutStretch along(double from, double to, SideLine line = 11, double off = 0) {
  return {line, at(from, 0.25 + off), at(to, 0.25 + off)};
}

void add(const CutStretch& stretch, CutStretches& stretches, const EdgeKey& edge = kEdge) {
  stretches.add(edge, stretch, stretch.a[kS], stretch.b[kS]);
}

std::vector<CutStretch> with_one_piece(CutStretches& stretches) {
  std::vector<CutStretch> found;
  stretches.find_with_one_piece(kUncertainty, found);
  std::erase_if(found, [](const CutStretch& x) { return !are_apart(x.a, x.b, kUncertainty); });
  return found;
}

TEST(CutStretches, WithPiecesOnBothSidesAreNotFound) {
  CutStretches stretches;
  add(along(2, 5), stretches);
  add(along(5, 3), stretches);
  add(along(3, 2), stretches);
  EXPECT_TRUE(with_one_piece(stretches).empty());
}

TEST(CutStretches, WithAPieceOnOneSideAreFoundAsThatPieceHasThem) {
  CutStretches stretches;
  add(along(2, 5), stretches);
  add(along(4, 3), stretches);
  add(along(8, 6, 12), stretches);
  const std::vector<CutStretch> found = with_one_piece(stretches);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].a[kS], 2);
  EXPECT_EQ(found[0].b[kS], 3);
  EXPECT_EQ(found[1].a[kS], 4);
  EXPECT_EQ(found[1].b[kS], 5);
  EXPECT_EQ(found[2].a[kS], 8);
  EXPECT_EQ(found[2].b[kS], 6);
  EXPECT_EQ(found[2].line, 12);
}

TEST(CutStretches, OfEdgesOnOneLineAreTheSameToWithinRoundingsOnly) {
  for (const double off : {0.0, 0x1p-50, -0x1p-50, 0x1p-40}) {
    CutStretches stretches;
    add(along(2, 5), stretches);
    add(along(6, 3, 12, off), stretches, {true, 3, 7});
    const std::vector<CutStretch> found = with_one_piece(stretches);
    ASSERT_EQ(found.size(), 2U) << off;
    const bool same = std::abs(off) < 0x1p-45;
    for (const CutStretch& left : found) EXPECT_EQ(std::abs(left.b[kS] - left.a[kS]), same ? 1 : 3) << off;
  }
}

TEST(CutStretches, OfDifferentEdgesAreKeptApart) {
  CutStretches stretches;
  add(along(2, 5), stretches);
  add({12, at(5, 0.5), at(2, 0.5)}, stretches, {false, 3, 8});
  EXPECT_EQ(with_one_piece(stretches).size(), 2U);
  stretches.clear();
  EXPECT_TRUE(with_one_piece(stretches).empty());
}

}  // namespace
}  // namespace pcm::fast::cut_stretches_test
