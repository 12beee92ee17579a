// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/error_budget.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/closed_forms.h"

namespace pcm::compare {
namespace {

/// Paraboloids of radius r R / (r + R): F tends to pi times it times the square of the depth.
TEST(ClosedForms, ShallowContactOfTwoSpheresIsThatOfParaboloids) {
  const long double r = 1, R = 3, depth = 1e-4L;
  const long double leading = closed_forms::kPi * r * R / (r + R) * depth * depth;
  EXPECT_NEAR(static_cast<double>(closed_forms::sphere_on_sphere(r, R, r + R - depth) / leading), 1, 1e-4);
}

TEST(ClosedForms, AVastSphereIsAPlane) {
  const long double plane = closed_forms::sphere_on_plane_sphere_master(1, 0.05L);
  EXPECT_NEAR(static_cast<double>(closed_forms::sphere_on_sphere(1, 1e6L, 1e6L + 0.95L) / plane), 1, 1e-5);
}

/// Leading terms of inscribed icospheres (edge e, depth h, r = 1): -e^2 / (4 h) for the clipped integral, and
/// -(2 h - h^2) / 24 (e / h)^2 more for the barycentric scheme.
TEST(ErrorBudget, SphereOnPlaneFollowsItsLeadingTermsAndRoundsAtMachineEpsilon) {
  const BudgetCase pair = budget_cases(3).front();
  const double h = 0.05;
  const BudgetLevel errors = error_budget(pair, 2, 5);
  EXPECT_EQ(errors.master_faces, 20480);
  const double e2 = errors.edge * errors.edge;
  ASSERT_TRUE(errors.geometry && errors.geometry_equal_volume);
  EXPECT_NEAR(*errors.geometry / (-e2 / (4 * h)), 1, 0.1);
  EXPECT_NEAR(errors.discretisation / (-(2 * h - h * h) / (24 * h * h) * e2), 1, 0.3);
  EXPECT_GE(errors.discretisation_single, std::abs(errors.discretisation));
  EXPECT_LT(std::abs(*errors.geometry_equal_volume), std::abs(*errors.geometry) / 5);
  for (const double rounding : {errors.rounding_barycentric, errors.rounding_clipped}) {
    EXPECT_GT(rounding, 0);
    EXPECT_LT(rounding, 0x1p-50 * pair.width / h);
  }
}

TEST(ErrorBudget, BubblesHaveNoClosedForm) {
  const BudgetLevel errors = error_budget(budget_cases(1).back(), 0, 2);
  EXPECT_EQ(errors.master_faces, 950);
  EXPECT_FALSE(errors.geometry || errors.geometry_equal_volume);
  EXPECT_GT(errors.discretisation_single, 0);
}

TEST(ErrorBudget, OrderIsThatOfTheLastThreeLevels) {
  ErrorBudget budget;
  for (const double edge : {1.0, 0.5, 0.25, 0.125}) {
    BudgetLevel& level = budget.levels.emplace_back();
    level.edge = edge;
    level.discretisation = edge == 1 ? -7 : 3 * edge * edge;
  }
  const auto order = observed_order(budget, [](const BudgetLevel& l) { return l.discretisation; });
  ASSERT_TRUE(order);
  EXPECT_NEAR(*order, 2, 1e-12);
  EXPECT_FALSE(observed_order(budget, [](const BudgetLevel& l) { return l.geometry; }));
}

}  // namespace
}  // namespace pcm::compare
