// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/posed/posed_team.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>

#include "fast/surface/prepare_surface.h"
#include "meshes/generate/boxes.h"

namespace pcm::fast {
namespace {

constexpr std::size_t kThreads = 3;

/// What of a team's threads throw their number is thrown on; empty where nothing is.
std::string thrown_on(PosedTeam& team, PosedPair& posed, const std::set<std::size_t>& throwing) {
  team.start();
  try {
    team.run(kThreads, posed, [&](std::size_t thread, PosedPair&) {
      if (throwing.count(thread) > 0) throw std::runtime_error(std::to_string(thread));
    });
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(PosedTeam, ThrowsOnWhatTheFirstOfItsThreadsThrewAndForgetsIt) {
  const PreparedSurface surface = prepare_surface(generate::box({1, 1, 1}));
  PosedPair posed;
  posed.place(surface, surface, {}, 0, false);
  PosedTeam team(kThreads);
  EXPECT_EQ(thrown_on(team, posed, {1}), "1");
  EXPECT_EQ(thrown_on(team, posed, {2}), "2");
  EXPECT_EQ(thrown_on(team, posed, {1, 2}), "1");
  EXPECT_EQ(thrown_on(team, posed, {0, 2}), "0");
  EXPECT_EQ(thrown_on(team, posed, {}), "");
}

}  // namespace
}  // namespace pcm::fast
