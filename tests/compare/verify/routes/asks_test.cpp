// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "compare/verify/routes/asks.h"

namespace pcm::compare {
namespace {

/// The switches of a question, as text.
std::string switches(const Ask& ask) {
  const Wanted& w = ask.wanted;
  const fast::Savings& s = ask.savings;
  std::string text;
  for (const bool x : {w.polygons, w.areas, w.force, w.elements, w.bound, w.statistics, w.tangent, s.broad_phase,
                       s.certificates, s.first_crossing, s.lazy_vertices, s.one_sided, s.velocities, s.only_wanted,
                       s.filters, s.known_poses, s.coherence})
    text += x ? '1' : '0';
  return text;
}

TEST(Asks, CoarseStatesAtRestDrawAllSwitchesBothWaysOnEachRouteThatDraws) {
  // Their doubles differ in few bits, all of them high ones.
  std::map<Route, std::set<std::string>> drawn;
  std::map<Route, std::array<int, 17>> on;
  bool differ = false;
  constexpr int kStates = 512;
  for (int k = 0; k < kStates; ++k) {
    Pose pose;
    const int x = k % 8, y = k / 8 % 8, z = k / 64;
    pose.r = Eigen::Vector3d(x, y, z) / 8;
    const auto plain = asks_at(pose, Velocity{}), known = known_pose_asks_at(pose, Velocity{}),
               pairings = scene_asks_at(pose, Velocity{});
    ASSERT_EQ(known.size(), 2U);
    ASSERT_EQ(pairings.size(), 2U);
    EXPECT_EQ(switches(known.front()), switches(Ask{}));
    EXPECT_EQ(switches(pairings.front()), switches(Ask{}));
    for (const Ask& ask : {plain.back(), known.back(), pairings.back()}) {
      const std::string text = switches(ask);
      drawn[ask.route].insert(text);
      for (std::size_t i = 0; i < text.size(); ++i) on[ask.route][i] += text[i] == '1';
    }
    differ |= switches(plain.back()) != switches(pairings.back()) && switches(plain.back()) != switches(known.back()) &&
              switches(known.back()) != switches(pairings.back());
  }
  EXPECT_TRUE(differ);
  for (const Route route : {Route::drawn, Route::known_pose, Route::scene}) {
    // Of 2^17 choices: 512 draws meet one of them twice.
    EXPECT_GE(drawn[route].size(), 490U) << name(route);
    // Five standard deviations.
    for (const int count : on[route]) EXPECT_NEAR(2 * count, kStates, 114) << name(route);
  }
}

}  // namespace
}  // namespace pcm::compare
