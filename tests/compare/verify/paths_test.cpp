// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "compare/verify/paths.h"

namespace pcm::compare {
namespace {

/// The switches of a question, as text.
std::string switches(const Ask& ask) {
  const Wanted& w = ask.wanted;
  const fast::Savings& s = ask.savings;
  std::string text;
  for (const bool x : {w.polygons, w.areas, w.force, w.elements, w.bound, w.statistics, s.broad_phase, s.certificates,
                       s.first_crossing, s.lazy_vertices, s.one_sided, s.velocities, s.only_wanted, s.filters})
    text += x ? '1' : '0';
  return text;
}

TEST(Paths, CoarseStatesAtRestDrawAllSwitchesBothWaysInEvaluateAndInScenes) {
  // Their doubles differ in few bits, all of them high ones.
  std::map<Path, std::set<std::string>> drawn;
  std::map<Path, std::array<int, 14>> on;
  bool differ = false;
  constexpr int kStates = 512;
  for (int k = 0; k < kStates; ++k) {
    Pose pose;
    pose.r = Eigen::Vector3d(k % 8, k / 8 % 8, k / 64) / 8;
    const std::vector<Ask> plain = asks_at(pose, Velocity{}), pairings = scene_asks_at(pose, Velocity{});
    ASSERT_EQ(pairings.size(), 2U);
    EXPECT_EQ(switches(pairings.front()), switches(Ask{}));
    for (const Ask& ask : {plain.back(), pairings.back()}) {
      const std::string text = switches(ask);
      drawn[ask.path].insert(text);
      for (std::size_t i = 0; i < text.size(); ++i) on[ask.path][i] += text[i] == '1';
    }
    differ |= switches(plain.back()) != switches(pairings.back());
  }
  EXPECT_TRUE(differ);
  for (const Path path : {Path::drawn, Path::scene}) {
    // Of 2^14 choices: 512 draws meet some 8 of them twice.
    EXPECT_GE(drawn[path].size(), 490U) << name(path);
    // Five standard deviations.
    for (const int count : on[path]) EXPECT_NEAR(count, kStates / 2, 57) << name(path);
  }
}

}  // namespace
}  // namespace pcm::compare
