// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>

#include "fast/crossings/crossings.h"

namespace pcm::fast {
namespace {

CrossingNode crossing_of(Side edge_side, Index edge, Index face) {
  CrossingNode node;
  node.edge_side = edge_side;
  node.edge = edge;
  node.face = face;
  return node;
}

/// A ball on a ground of two triangles: with one place for all of a face's crossings a search would walk along them.
TEST(CrossingIndex, EdgesThroughOneFaceAndFacesOnOneEdgeAreLookedForInDifferentPlaces) {
  for (const int log2_places : {8, 11, 14}) {
    const Index half = Index{1} << (log2_places - 1);  // as full as a table ever is
    for (const Side side : {Side::E, Side::F})
      for (const Index stride : {1, 2, 3, 64}) {
        std::set<std::size_t> of_face, of_edge;
        for (Index i = 0; i < half; ++i) {
          of_face.insert(CrossingIndex::first_place(crossing_of(side, stride * i, 7).key(), log2_places));
          of_edge.insert(CrossingIndex::first_place(crossing_of(side, 7, stride * i).key(), log2_places));
        }
        EXPECT_GT(of_face.size(), half / 3U) << log2_places << " bits, every edge of " << stride;
        EXPECT_GT(of_edge.size(), half / 3U) << log2_places << " bits, every face of " << stride;
        EXPECT_LT(*of_face.rbegin(), std::size_t{1} << log2_places);
      }
  }
}

TEST(CrossingIndex, FindsEachKeyWhereItWasEnteredHoweverManyThereAreAndForgetsThemAtItsStart) {
  CrossingIndex index;
  for (int round = 0; round < 3; ++round) {
    index.start();
    constexpr Index kKeys = 3000;
    for (Index i = 0; i < kKeys; ++i) ASSERT_EQ(index.find_or_insert(crossing_of(Side::F, i, 5).key(), i), i);
    for (Index i = kKeys; i-- > 0;) ASSERT_EQ(index.find_or_insert(crossing_of(Side::F, i, 5).key(), kKeys), i);
    ASSERT_EQ(index.find_or_insert(crossing_of(Side::E, 0, 5).key(), kKeys), kKeys);
  }
}

}  // namespace
}  // namespace pcm::fast
