// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/crossings/candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>

namespace pcm::reference {
namespace {

/// Corners on a coarse grid, so that boxes often touch without overlapping.
std::vector<Box> random_boxes(std::size_t count, std::mt19937_64& random) {
  const auto draw = [&random](int below) { return static_cast<double>(random() % static_cast<std::uint64_t>(below)); };
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d lower(draw(12), draw(12), draw(12));
    boxes.push_back({lower, lower + Eigen::Vector3d(draw(4), draw(4), draw(4))});
  }
  return boxes;
}

std::vector<IndexPair> all_that_meet(const std::vector<Box>& a, const std::vector<Box>& b) {
  std::vector<IndexPair> pairs;
  for (Index i = 0; i < static_cast<Index>(a.size()); ++i)
    for (Index j = 0; j < static_cast<Index>(b.size()); ++j)
      if (a[i].meets(b[j])) pairs.emplace_back(i, j);
  return pairs;
}

TEST(MeetingBoxes, AreThoseOfAllPairsThatMeetAlsoInATreeOfOtherPlaces) {
  const std::uint64_t seed = 3;
  std::cout << "seed " << seed << "\n";
  std::mt19937_64 random(seed);
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t n = 1 + random() % 90, m = 1 + random() % 90;
    const std::vector<Box> a = random_boxes(n, random), b = random_boxes(m, random), moved = random_boxes(n, random);
    const BoxTree tree_a(a), tree_b(b), tree_moved(tree_a, moved);
    EXPECT_EQ(meeting_boxes(tree_a, tree_b), all_that_meet(a, b));
    EXPECT_EQ(meeting_boxes(tree_moved, tree_b), all_that_meet(moved, b));
    std::vector<IndexPair> with_first;
    tree_b.for_each_meeting(moved[0], [&](Index j) { with_first.emplace_back(0, j); });
    std::sort(with_first.begin(), with_first.end());
    EXPECT_EQ(with_first, all_that_meet({moved[0]}, b));
  }
}

TEST(MeetingBoxes, AreNoneWithoutBoxes) {
  const BoxTree none{std::vector<Box>{}}, one{{Box{{0, 0, 0}, {1, 1, 1}}}};
  EXPECT_TRUE(meeting_boxes(none, one).empty());
  EXPECT_TRUE(meeting_boxes(one, none).empty());
}

}  // namespace
}  // namespace pcm::reference
