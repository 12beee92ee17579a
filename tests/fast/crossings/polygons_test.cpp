// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/crossings/polygons.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace pcm::fast::polygons_test {
namespace {

/// Crossings of one edge each, edge i in node i, none chained yet.
Crossings unchained(int count) {
  Crossings crossings;
  crossings.nodes.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) crossings.nodes[static_cast<std::size_t>(i)].edge = i;
  return crossings;
}

void chain(Crossings& crossings, Index from, Index to) {
  crossings.nodes[static_cast<std::size_t>(from)].next = to;
  crossings.nodes[static_cast<std::size_t>(to)].has_previous = true;
}

TEST(Polygons, OpenOneStartsWhereItsCirculationDoesHoweverLateThatWasFound) {
  constexpr Index kCount = 1000;
  Crossings crossings = unchained(kCount);
  for (Index i = kCount - 1; i > 0; --i) chain(crossings, i, i - 1);
  std::vector<Index> unsorted;
  PolygonChains chains;
  chain_polygons(crossings, unsorted, chains);
  ASSERT_EQ(chains.polygons.size(), 1);
  EXPECT_FALSE(chains.polygons[0].closed);
  EXPECT_EQ(chains.polygons[0].count, kCount);
  ASSERT_EQ(chains.crossing_order.size(), kCount);
  for (Index i = 0; i < kCount; ++i) EXPECT_EQ(chains.crossing_order[static_cast<std::size_t>(i)], kCount - 1 - i);
}

TEST(Polygons, ClosedOnesStartAtTheirSmallestCrossingAndAreSortedByIt) {
  Crossings crossings = unchained(8);
  for (const auto& [from, to] : {std::pair{7, 3}, {3, 5}, {5, 7}, {6, 1}, {1, 2}, {2, 6}, {4, 0}})
    chain(crossings, from, to);
  std::vector<Index> unsorted;
  PolygonChains chains;
  chain_polygons(crossings, unsorted, chains);
  EXPECT_EQ(chains.crossing_order, (std::vector<Index>{1, 2, 6, 3, 5, 7, 4, 0}));
  ASSERT_EQ(chains.polygons.size(), 3);
  EXPECT_TRUE(chains.polygons[0].closed);
  EXPECT_TRUE(chains.polygons[1].closed);
  EXPECT_FALSE(chains.polygons[2].closed);  // from 4 to 0, and sorted by 4
  for (Index p = 0; p < 3; ++p) {
    const Polygon& polygon = chains.polygons[static_cast<std::size_t>(p)];
    for (Index i = polygon.first; i < polygon.first + polygon.count; ++i)
      EXPECT_EQ(crossings[chains.crossing_order[static_cast<std::size_t>(i)]].polygon, p);
  }
}

}  // namespace
}  // namespace pcm::fast::polygons_test
