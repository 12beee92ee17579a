// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/verify/verdict/checks.h"
#include "compare/verify/verdict/tally.h"

namespace pcm::compare {
namespace {

TEST(Tally, BoundOnTheRateIsThreeOverNWithoutDisagreements) {
  Tally tally;
  PoseOutcome outcome;
  for (int k = 0; k < 1000; ++k) tally.add(outcome, std::to_string(k));
  EXPECT_NEAR(tally.disagreement_rate_bound(), 0.002991, 1e-6);  // 1 - 0.05^(1 / 1000)
}

TEST(Tally, QuantilesAreRoundedUpByA64thAtMost) {
  Histogram histogram;
  for (int k = 1; k <= 1000; ++k) histogram.add(1e-17 * k);
  for (const double q : {0.5, 0.99, 0.999, 1.0}) {
    EXPECT_GE(histogram.quantile(q), 1e-14 * q * (1 - 1e-12));
    EXPECT_LE(histogram.quantile(q), 1e-14 * q * (1 + 1.0 / 64) * (1 + 1e-12));
  }
  EXPECT_EQ(Histogram().quantile(0.5), 0);
}

TEST(Tally, WhatIsNoFiniteNumberIsGreaterThanAllOthers) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double no_number : {kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    Histogram histogram;
    for (int k = 0; k < 9; ++k) histogram.add(std::numeric_limits<double>::max());
    histogram.add(no_number);
    EXPECT_EQ(histogram.quantile(0.9), std::numeric_limits<double>::max());
    EXPECT_EQ(histogram.quantile(1), kInfinity);
    PoseOutcome outcome;
    outcome.errors.force = 1;
    Tally tally;
    tally.add(outcome, "a");
    outcome.errors.force = no_number;
    tally.add(outcome, "b");
    const Tally again = Tally::from_json(nlohmann::ordered_json::parse(tally.to_json().dump()));
    for (const Tally& known : {tally, again}) {
      EXPECT_EQ(known.worst[4].value, kInfinity);
      EXPECT_EQ(known.worst[4].pose, "b");
      EXPECT_EQ(known.error_quantile(4, 1), kInfinity);
    }
  }
}

TEST(Tally, ChecksOfZeroAreCountedApartAndNotAsInfinite) {
  Checks checks;
  checks.check_value(Kind::force, "a", 0, 0, 0, 0);     // nothing to hold
  checks.check_value(Kind::force, "b", 0, 0, 1e-3, 0);  // of 0
  checks.check_value(Kind::force, "c", 2, 2, 1e-3, 2);
  checks.check_value(Kind::force, "d", 2, 2, std::numeric_limits<double>::infinity(), 0);
  checks.check_value(Kind::force, "e", 1e-320, 1e-320, 1, 1e-320);  // finite, though no double tells it
  Widths widths;
  for (const Width& width : checks.widths()) widths.add(width);
  EXPECT_EQ(widths.count(), 4);
  EXPECT_EQ(widths.of_zero, 1);
  EXPECT_EQ(widths.infinite, 1);
  EXPECT_EQ(widths.wider, 1);
  EXPECT_NEAR(widths.quantile(0.3), 5e-4, 5e-4 / 64);
  EXPECT_EQ(widths.quantile(0.6), std::numeric_limits<double>::max());
  EXPECT_EQ(widths.quantile(1), std::numeric_limits<double>::infinity());
}

TEST(Checks, NoNumberDisagreesWhereverItStands) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  const auto agrees = [](double subj, double truth, double bound) {
    Checks of_number, of_vector;
    of_number.check_value(Kind::force, "number", subj, truth, bound, 1);
    of_vector.check_vector(Kind::force, "vector", {0, subj, 0}, {0, truth, 0}, bound, 1);
    EXPECT_EQ(of_number.disagreements().empty(), of_vector.disagreements().empty());
    return of_number.disagreements().empty();
  };
  EXPECT_TRUE(agrees(1, 1, 0));
  EXPECT_TRUE(agrees(kInfinity, kInfinity, 0));
  EXPECT_FALSE(agrees(kInfinity, -kInfinity, 1));
  EXPECT_FALSE(agrees(kNaN, 1, kInfinity));
  EXPECT_FALSE(agrees(1, kNaN, kInfinity));
  EXPECT_FALSE(agrees(1, 1, kNaN));
  EXPECT_FALSE(agrees(kInfinity, kInfinity, kNaN));
}

}  // namespace
}  // namespace pcm::compare
