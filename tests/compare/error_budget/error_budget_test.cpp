// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/error_budget/error_budget.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/bodies/closed_forms.h"
#include "compare/bodies/smooth_bubble.h"
#include "compare/known_answers/report.h"
#include "meshes/files/text_file.h"
#include "meshes/generate/bubbles.h"
#include "tests/compare/run_pcm.h"
#include "tests/meshes/temporary_folder.h"

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

TEST(SmoothBubble, HasTheVolumeItsMeshesTendTo) {
  const double smooth = smooth_bubble_volume(0.4);
  const double coarse = smooth - enclosed_volume(generate::bubble(0.4, 4));
  const double fine = smooth - enclosed_volume(generate::bubble(0.4, 8));
  EXPECT_GT(fine, 0);
  EXPECT_LT(fine, 1e-3 * smooth);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.01);
}

/// Shallow: two paraboloids of the poles' radius of curvature rho, F = pi (rho / 2) depth^2.
TEST(SmoothBubble, PoleUponPoleIsAContactOfParaboloids) {
  const double length = 3, depth = 1e-3;
  // d(t) = 1/2 + cos^2 t = 3/2 - t^2 + ...: the height d cos t = 3/2 - 7/4 t^2 at the radius 3/2 t.
  const double rho = 1.5 * 1.5 / (2 * 1.75);
  const Eigen::Vector3d force = smooth_bubble_force(length, {Eigen::Matrix3d::Identity(), {0, 0, 3 - depth}}, 3000);
  EXPECT_NEAR(force.z() / (static_cast<double>(closed_forms::kPi) * rho / 2 * depth * depth), 1, 1e-2);
  EXPECT_NEAR(force.x(), 0, 1e-9 * force.z());
  EXPECT_NEAR(force.y(), 0, 1e-9 * force.z());
}

TEST(SmoothBubble, ApartThereIsNoForce) {
  EXPECT_EQ(smooth_bubble_force(1, {Eigen::Matrix3d::Identity(), {0, 0, 1.001}}, 100).norm(), 0);
}

TEST(SmoothBubble, TwiceAsManyCellsChangeLittle) {
  const Placement placement = budget_of_bubbles(Extent::quick).front().placement(3);
  const Eigen::Vector3d coarse = smooth_bubble_force(0.4, placement, 1500);
  const Eigen::Vector3d fine = smooth_bubble_force(0.4, placement, 3000);
  EXPECT_LT((coarse - fine).norm(), 2e-5 * fine.norm());
}

/// Pole upon pole again: the poles' triangles have the sides a = (length / 2) pi / (20 finer) along the meridian and
/// next to nothing across, so that each mesh takes a^2 / (12 rho) of the depth, over the contact's area pi rho depth.
TEST(SmoothBubble, MeshesTakeTheirInsetFromAPolesContact) {
  const double length = 3, depth = 1e-3, rho = 1.5 * 1.5 / (2 * 1.75);
  const auto pi = static_cast<double>(closed_forms::kPi);
  const double a = length / 2 * pi / (20 * 4), inset = a * a / (12 * rho);
  const Placement placement{Eigen::Matrix3d::Identity(), {0, 0, 3 - depth}};
  const double as_meshed = force_lost_to_meshes(length, placement, {4, false}, 3000).z();
  EXPECT_NEAR(as_meshed / (2 * inset * pi * rho * depth), 1, 0.02);
  EXPECT_LT(force_lost_to_meshes(length, placement, {4, true}, 3000).z(), as_meshed);
}

/// The coarsest level of the pair alone.
BudgetCase coarsest(BudgetCase pair) {
  pair.levels = 1;
  for (Expectation* e : {&pair.discretisation, &pair.one_pose, &pair.geometry, &pair.geometry_equal_volume}) *e = {};
  return pair;
}

TEST(ErrorBudget, KindsOfErrorAreApart) {
  const BudgetCase pair = coarsest(budget_of_spheres(Extent::quick).front());
  const KnownAnswerResult result = run(budget_problem(pair, Extent::quick));
  ASSERT_EQ(result.series.size(), kBudgetRows);
  EXPECT_EQ(result.missed(), 0u);
  const auto finest = [&](BudgetRow row) { return row_of(result, row).levels.back(); };
  EXPECT_LT(finest(BudgetRow::rounding_barycentric).value, 1e-14);
  EXPECT_LT(finest(BudgetRow::rounding_clipped).value, 1e-14);
  EXPECT_GT(finest(BudgetRow::rounding_clipped).value, 0);
  EXPECT_LT(finest(BudgetRow::discretisation).value, -0.02);
  EXPECT_GE(finest(BudgetRow::one_pose).rms, std::abs(finest(BudgetRow::discretisation).value));
  EXPECT_LT(finest(BudgetRow::geometry).deviation, -0.08);
  EXPECT_LT(std::abs(finest(BudgetRow::geometry_equal_volume).deviation), 0.01);
}

TEST(ErrorBudget, AnExpectationOutOfReachIsMissedAndNamed) {
  BudgetCase pair = coarsest(budget_of_spheres(Extent::quick).front());
  pair.geometry.finest = within(1e-3);
  std::vector<KnownAnswerResult> budget;
  budget.push_back(run(budget_problem(pair, Extent::quick)));
  EXPECT_EQ(budget.front().missed(), 1u);
  EXPECT_EQ(error_budget_verdict(budget), "error budget NOT met: 1 cases, 6 rows, 1 missed");
  EXPECT_NE(error_budget_summary(budget).find("missed: sphere on plane, geometry"), std::string::npos);
}

TEST(ErrorBudget, EveryRowHasACheckAtBothExtents) {
  for (const Extent extent : {Extent::quick, Extent::full})
    for (const auto family : {budget_of_spheres, budget_of_cylinders, budget_of_bubbles})
      for (const BudgetCase& pair : family(extent))
        for (const Expectation* e : {&pair.discretisation, &pair.one_pose, &pair.geometry, &pair.geometry_equal_volume})
          EXPECT_TRUE(e->order || std::isfinite(e->finest.greatest)) << pair.title;
}

TEST(ErrorBudget, HasTheSameTablesForAnyNumberOfThreads) {
  const auto tables = [](int jobs) {
    std::vector<KnownAnswerResult> budget;
    oneapi::tbb::task_arena arena(jobs);
    arena.execute([&] {
      budget.push_back(run(budget_problem(coarsest(budget_of_bubbles(Extent::quick).front()), Extent::quick)));
    });
    return cases_json(budget).dump();
  };
  EXPECT_EQ(tables(1), tables(2));
}

/// The program on coarser meshes: every row met, every table written.
TEST(ErrorBudget, ProgramMeetsEveryRowAndWritesItsTables) {
  const TemporaryFolder scratch;
  const Outcome outcome = run_pcm({"verify", "--error-budget", "--quick", "--out", scratch.path("budget")});
  std::cout << outcome.out;
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(lines_of(outcome.out).back(), "error budget met: 7 cases, 42 rows, 0 missed");
  const std::filesystem::path folder = scratch.path("budget");
  const std::string page = read_text_file(folder / "error_budget.md");
  EXPECT_NE(page.find("| bubble on bubble |"), std::string::npos);
  const auto json = nlohmann::json::parse(read_text_file(folder / "error_budget.json"));
  EXPECT_TRUE(json.at("verdict").at("met").get<bool>());
  EXPECT_EQ(json.at("cases").size(), 7u);
  EXPECT_EQ(json.at("cases").at(0).at("rows").size(), kBudgetRows);
  // A line for each level of each row, below the names of the columns.
  EXPECT_EQ(lines_of(read_text_file(folder / "error_budget.csv")).size(), 1 + 7 * kBudgetRows * 3);
  for (const auto& page_of_case : json.at("cases"))
    EXPECT_TRUE(std::filesystem::exists(folder / (page_of_case.at("id").get<std::string>() + ".md")));
}

}  // namespace
}  // namespace pcm::compare
