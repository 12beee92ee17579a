// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/uncertain_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "reference/numbers/numbers.h"

namespace pcm::compare {
namespace {

using reference::Rational;

/// A number as it is, as doubles have it, and as it is said to be.
struct Known {
  Rational exact;
  double computed;
  UncertainNumber uncertain;
};

void expect_within(const Known& x) {
  if (!std::isfinite(x.uncertain.error)) return;
  const Rational value(x.uncertain.value), error(x.uncertain.error);
  EXPECT_LE(CGAL::abs(Rational(x.exact - value)), error);
  EXPECT_LE(std::abs(x.computed - x.uncertain.value), x.uncertain.error);
}

TEST(UncertainNumber, HoldsTheNumberAndWhatDoublesMakeOfIt) {
  std::mt19937_64 random(20);
  std::cout << "seed 20\n";
  std::uniform_real_distribution<double> any(-1, 1);
  const auto leaf = [&]() -> Known {
    const double x = any(random), off = 1e-9 * any(random);
    const Rational exact = Rational(x) + Rational(off);
    return {exact, x, UncertainNumber(x, std::abs(off))};
  };
  int known = 0;
  for (int round = 0; round < 5000; ++round) {
    Known x = leaf();
    for (int depth = 0; depth < 12; ++depth) {
      const Known y = leaf();
      switch (random() % 4) {
        case 0:
          x = {Rational(x.exact + y.exact), x.computed + y.computed, x.uncertain + y.uncertain};
          break;
        case 1:
          x = {Rational(x.exact - y.exact), x.computed - y.computed, x.uncertain - y.uncertain};
          break;
        case 2:
          x = {Rational(x.exact * y.exact), x.computed * y.computed, x.uncertain * y.uncertain};
          break;
        default:
          x = {Rational(x.exact / y.exact), x.computed / y.computed, x.uncertain / y.uncertain};
      }
      expect_within(x);
    }
    known += std::isfinite(x.uncertain.error);
  }
  EXPECT_GT(known, 4900);
}

TEST(UncertainNumber, OfAQuotientByWhatMayBeZeroNothingIsKnown) {
  const UncertainNumber one(1), about_zero(1e-20, 1e-19);
  EXPECT_FALSE(std::isfinite((one / about_zero).error));
  EXPECT_TRUE((UncertainNumber() / about_zero).is_zero());
  EXPECT_TRUE((UncertainNumber() * UncertainNumber::nothing_known()).is_zero());
}

TEST(UncertainNumber, WhatIsNoNumberOrTooLargeIsNotKnown) {
  EXPECT_FALSE(std::isfinite(UncertainNumber(std::nan("")).error));
  EXPECT_FALSE(std::isfinite((UncertainNumber(1e300) * UncertainNumber(1e300)).error));
}

TEST(UncertainNumber, ChoosesWhereItIsSureAndElseHoldsBoth) {
  const UncertainNumber below(1), from(4, 0.5);
  EXPECT_EQ(where_below(UncertainNumber(2, 0.5), 3, below, from).value, 1);
  EXPECT_EQ(where_below(UncertainNumber(3, 0), 3, below, from).value, 4);
  const UncertainNumber both = where_below(UncertainNumber(2.9, 0.2), 3, below, from);
  EXPECT_LE(both.value - both.error, 1);
  EXPECT_GE(both.value + both.error, 4.5);
}

}  // namespace
}  // namespace pcm::compare
