// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answer_dynamics.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace pcm::compare {
namespace {

/// Every row is within its bound, and over the tolerances the error falls with an order of at least 0.6 (a step's error
/// is proportional to the tolerance; kinks of the force make it fall in jumps).
void expect_met(const std::vector<DynamicAnswer>& answers) {
  EXPECT_FALSE(answers.empty());
  std::map<std::string, std::vector<DynamicAnswer>> series;
  for (const DynamicAnswer& a : answers) series[a.id + a.quantity + a.parameter].push_back(a);
  for (const auto& [name, s] : series) {
    const double decades = std::log10(s.front().tolerance / s.back().tolerance);
    EXPECT_GT(std::log10(s.front().relative_error() / s.back().relative_error()), 0.6 * decades) << name;
  }
  for (const DynamicAnswer& a : answers) {
    fmt::print("{} {:24} {:32} rtol {:.0e} {:.12g} {:.12g} error {:.1e} bound {:.1e} steps {} evaluations {}\n", a.id,
               a.quantity, a.parameter, a.tolerance, a.computed, a.expected, a.relative_error(), a.bound, a.steps,
               a.derivatives);
    EXPECT_TRUE(a.met());
  }
}

TEST(KnownAnswerDynamics, FlatBouncesHaveTheirRestitution) {
  expect_met(flat_bounces({}));
}

TEST(KnownAnswerDynamics, SphereDropsFollowThePolyhedron) {
  expect_met(sphere_drops({}));
}

TEST(KnownAnswerDynamics, FrictionStopsAndLetsCreep) {
  expect_met(frictional_slides({}));
}

}  // namespace
}  // namespace pcm::compare
