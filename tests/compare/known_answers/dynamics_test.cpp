// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/dynamics.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "compare/known_answers/problems.h"

namespace pcm::compare {
namespace {

void print(const DynamicAnswer& a) {
  fmt::print("{} {} {} {}: {:.12g} for {:.12g}, error {:.1e}, bound {:.1e}, {} steps, {} evaluations\n", a.id,
             a.quantity, a.parameter, a.level, a.computed, a.expected, a.relative_error(), a.bound, a.steps,
             a.derivatives);
}

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
    print(a);
    EXPECT_TRUE(a.met());
  }
}

/// Every second tolerance, to be quick.
DynamicPlan plan_of(Scheme scheme) {
  DynamicPlan plan;
  plan.tolerances = {1e-4, 1e-6, 1e-8, 1e-10, 1e-12};
  plan.scheme = scheme;
  return plan;
}

class KnownAnswerDynamics : public testing::TestWithParam<Scheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, KnownAnswerDynamics, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& tested) {
                           return tested.param == Scheme::clipped ? "Clipped" : "Barycentric";
                         });

TEST_P(KnownAnswerDynamics, FlatBouncesHaveTheirRestitution) {
  expect_met(flat_bounces(plan_of(GetParam())));
}

TEST_P(KnownAnswerDynamics, SphereDropsFollowThePolyhedron) {
  expect_met(sphere_drops(plan_of(GetParam())));
}

TEST_P(KnownAnswerDynamics, FrictionStopsAndLetsCreep) {
  expect_met(frictional_slides(plan_of(GetParam())));
}

TEST(KnownAnswerGeometry, PolyhedraTendToTheSphereWithSecondOrder) {
  std::map<std::string, std::vector<DynamicAnswer>> series;
  for (const DynamicAnswer& a : sphere_geometry({3, 4}, 1e-9)) {
    print(a);
    EXPECT_TRUE(a.met());
    series[a.id + a.quantity + a.parameter].push_back(a);
  }
  ASSERT_EQ(series.size(), 7U);
  for (const auto& [name, s] : series) {
    if (!s.front().second_order) continue;
    const double order = std::log(s.front().relative_error() / s.back().relative_error()) /
                         std::log(s.front().resolution / s.back().resolution);
    EXPECT_NEAR(order, 2, 0.1) << name;
  }
}

TEST(KnownAnswerMotions, HaveASeriesForEachQuantityAndScheme) {
  std::map<std::string, std::size_t> series;
  for (const KnownAnswer& problem : motions(Extent::quick)) {
    series[problem.id] = problem.series.size();
    EXPECT_EQ(run(problem).missed(), 0U) << problem.id;
  }
  const std::map<std::string, std::size_t> expected{{"A12", 24}, {"A13", 8}, {"A14", 22},
                                                    {"A15", 3},  {"A16", 2}, {"A17", 2}};
  EXPECT_EQ(series, expected);
}

}  // namespace
}  // namespace pcm::compare
