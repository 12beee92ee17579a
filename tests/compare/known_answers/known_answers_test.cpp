// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/known_answers.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <array>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/bodies/closed_forms.h"
#include "compare/known_answers/problems.h"
#include "compare/known_answers/report.h"

namespace pcm::compare {
namespace {

using namespace closed_forms;

TEST(ClosedForms, HaveTheirPublishedNumbers) {
  const auto expect = [](long double value, double published) {
    EXPECT_NEAR(static_cast<double>(value) / published, 1, 3e-6);
  };
  expect(sphere_on_plane_sphere_master(1, 0.01L), 3.14159e-4);
  expect(sphere_on_plane_sphere_master(1, 0.2L), 0.125664);
  expect(sphere_on_plane_plane_master(1, 0.01L), 3.13112e-4);
  expect(sphere_on_plane_plane_master(1, 0.05L), 7.72308e-3);
  expect(sphere_on_plane_plane_master(1, 0.2L), 0.117286);
  expect(cylinder_on_plane_cylinder_master(1, 0.05L), 0.0211350);
  expect(cylinder_on_plane_plane_master(1, 0.05L), 0.0209230);
  expect(sphere_in_socket_sphere_master(1, 1.01L, 0.02L), 0.0132667);
  expect(sphere_in_socket_sphere_master(1, 1, 0.02L), 2.11010 * 0.02);
  expect(journal_in_bore_journal_master(1, 1, 0.02L), 1.57746 * 0.02);
  expect(hertz_equal_at(1, 0.2L, 0.2L), 0.125664);
}

// What textbooks have in their place: to first order in the depth over the radius.
TEST(ClosedForms, TendToTheirFirstOrders) {
  const long double pi = std::acos(-1.0L);
  const auto cylinder = [](long double h) { return 4 * std::sqrt(2.0L) / 3 * h * std::sqrt(h); };
  EXPECT_NEAR(static_cast<double>(cylinder(0.05L)), 0.0210819, 5e-8);
  // The gap D, k = D / d.
  const auto socket = [pi](long double D, long double d) {
    const long double k = D / d;
    return 2 * pi * (d * (1 - k * k * k) / 3 - D * (1 - k * k) / 2);
  };
  EXPECT_NEAR(static_cast<double>(socket(0.01L, 0.02L)), 0.0130900, 5e-8);
  EXPECT_NEAR(static_cast<double>(socket(0, 0.02L)), 2.09440 * 0.02, 5e-7);
  EXPECT_NEAR(static_cast<double>(pi / 2 * 0.02L), 1.57080 * 0.02, 5e-7);
  for (const long double d : {1e-2L, 1e-3L, 1e-4L}) {
    const auto tends = [d](long double value, long double first_order) {
      EXPECT_NEAR(static_cast<double>(value / first_order), 1, 2 * static_cast<double>(d)) << static_cast<double>(d);
    };
    tends(cylinder_on_plane_cylinder_master(1, d), cylinder(d));
    tends(cylinder_on_plane_plane_master(1, d), cylinder(d));
    tends(sphere_in_socket_sphere_master(1, 1, d), socket(0, d));
    tends(sphere_in_socket_socket_master(1, 1, d), socket(0, d));
    tends(sphere_in_socket_sphere_master(1, 1 + d / 2, d), socket(d / 2, d));
    tends(journal_in_bore_journal_master(1, 1, d), pi / 2 * d);
    tends(journal_in_bore_bore_master(1, 1, d), pi / 2 * d);
  }
}

/// A series whose deviations are the given ones.
struct Measured {
  explicit Measured(const std::array<double, 4>& deviations) {
    double edge = 1;
    for (const double d : deviations) {
      levels.push_back({"", edge, 0, 0, {}});
      results.push_back({10 * (1 + d), d, d, d});
      edge /= 2;
    }
  }
  Convergence statistics() const { return convergence(levels, results, 10); }

  std::vector<Resolution> levels;
  std::vector<LevelResult> results;
};

TEST(Convergence, OfASecondOrderSeriesIsTwoAndExtrapolatesToTheReference) {
  const Convergence c = Measured({0.5, 0.16, 0.04, 0.01}).statistics();
  EXPECT_NEAR(c.order.value(), 2, 1e-12);
  EXPECT_NEAR(c.order_of_values.value(), 2, 1e-12);
  EXPECT_NEAR(c.richardson.value(), 10, 1e-12);
  EXPECT_NEAR(c.grid_convergence_index.value(), 1.25 * 0.01, 1e-12);
}

TEST(Convergence, OfDeviationsOfBothSignsHasNoOrder) {
  EXPECT_FALSE(Measured({0.5, 0.16, 0.04, -0.01}).statistics().order);
}

TEST(Convergence, OfRoundingHasNoOrder) {
  EXPECT_FALSE(Measured({4e-15, 3e-15, 2e-15, 1e-15}).statistics().order);
}

TEST(Convergence, OfValuesThatOscillateIsNotExtrapolated) {
  const Convergence c = Measured({0.5, 0.1, 0.3, 0.2}).statistics();
  EXPECT_FALSE(c.order_of_values);
  EXPECT_FALSE(c.richardson);
}

TEST(KnownAnswers, ARowOutOfItsBandIsMissed) {
  Series series;
  series.reference = 2;
  series.scale = 2;
  series.levels = {{"only", 1, 1, 0, within(1e-3)}};
  series.measure = [](std::size_t, int, fast::Workspace&) { return 2.01; };
  KnownAnswer problem;
  problem.series = {series};
  EXPECT_EQ(run(problem).missed(), 1u);
  problem.series[0].levels[0].deviation = within(1e-2);
  EXPECT_EQ(run(problem).missed(), 0u);
  problem.series[0].order = Band{1.9, 2.1};
  EXPECT_EQ(run(problem).missed(), 1u) << "an order that cannot be observed is not met";
}

TEST(KnownAnswers, HaveTheSameTablesForAnyNumberOfThreads) {
  const auto tables = [](int jobs) {
    KnownAnswersReport report;
    oneapi::tbb::task_arena arena(jobs);
    arena.execute([&] {
      for (KnownAnswer& problem : volumes(Extent::quick)) report.problems.push_back(run(std::move(problem)));
    });
    return known_answers_json(report).dump();
  };
  EXPECT_EQ(tables(1), tables(2));
}

TEST(KnownAnswers, AreMetOnCoarseMeshes) {
  KeptValues none;
  const KnownAnswersReport report = run_known_answers(Extent::quick, 1, 2, none, [](const std::string&) {});
  std::cout << known_answers_summary(report);
  EXPECT_TRUE(report.met());
}

}  // namespace
}  // namespace pcm::compare
