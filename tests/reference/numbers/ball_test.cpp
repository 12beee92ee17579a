// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/numbers/ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <random>

#include "reference/numbers/double_double.h"

namespace pcm::reference {
namespace {

TEST(Ball, OperationsEncloseTheRationalResultForAllSigns) {
  const std::uint64_t seed = 5;
  std::cout << "seed " << seed << "\n";
  std::mt19937_64 random(seed);
  const Field<Ball> field{60};
  const auto draw = [&random] { return static_cast<double>(static_cast<int>(random() % 41) - 20) / 8; };
  for (int i = 0; i < 4000; ++i) {
    const double a0 = draw(), a1 = draw(), b0 = draw(), b1 = draw(), s = static_cast<double>(random() % 9) / 8;
    const double x = a0 + s * (a1 - a0), y = b1 + s * (b0 - b1);  // exact: small dyadic numbers
    const Ball a = hull(field(a0), field(a1)), b = hull(field(b0), field(b1));
    // A difference of one sign would put the value outside.
    const auto holds = [](const Ball& ball, const Rational& value) {
      return (ball - Ball(value, 200)).sign().value_or(0) == 0;
    };
    EXPECT_TRUE(holds(a + b, Rational(x) + Rational(y)));
    EXPECT_TRUE(holds(a - b, Rational(x) - Rational(y)));
    EXPECT_TRUE(holds(a * b, Rational(x) * Rational(y))) << a0 << " " << a1 << " " << b0 << " " << b1;
    if (y != 0) {
      EXPECT_TRUE(holds(a / b, Rational(x) / Rational(y))) << a0 << " " << a1 << " " << b0 << " " << b1;
    }
    EXPECT_TRUE(holds(min(a, b), std::min(Rational(x), Rational(y))));
    EXPECT_TRUE(holds(max(a, b), std::max(Rational(x), Rational(y))));
    if (x >= 0) {
      EXPECT_TRUE(holds(sqrt(a * a), Rational(x)));
    }
  }
}

TEST(Ball, RoundsOnlyWhereBothEndsAgree) {
  const Field<Ball> field{100};
  EXPECT_EQ((field(1.0) / field(3.0)).rounded(), 1.0 / 3.0);
  EXPECT_FALSE(hull(field(1.0), field(2.0)).rounded().has_value());
  EXPECT_EQ((field(0.0) * field(-1.0)).rounded(), 0.0);
  EXPECT_FALSE(std::signbit(*(field(0.0) * field(-1.0)).rounded()));
  EXPECT_FALSE((field(1.0) / hull(field(-1.0), field(1.0))).rounded().has_value());
}

/// Of the number kinds alike: what may be anything, however it came about, is never settled by what is done with it.
template <class T>
void expect_unknown_to_stay_unknown(const Field<T>& field) {
  const T zero = field(0.0), one = field(1.0), five = field(5.0);
  const T around_zero = hull(field(-1.0), one), from_zero = hull(zero, one);
  for (const T& unknown : {T(one / zero), T(one / around_zero), T(zero / zero), T(field(-1.0) / from_zero)}) {
    EXPECT_FALSE(unknown.rounded().has_value());
    EXPECT_FALSE(unknown.sign().has_value());
    for (const T& x : {zero, one, five, around_zero, from_zero, T(zero - five), unknown})
      for (const T& y : {T(x + unknown), T(x - unknown), T(unknown - x), T(unknown / one), T(one / unknown),
                         T(five + from_zero * unknown), T(five + unknown * around_zero), T(unknown * unknown)}) {
        EXPECT_FALSE(y.rounded().has_value());
        EXPECT_FALSE(y.sign().has_value() && x.sign() != y.sign());
        EXPECT_FALSE(max(y, x).rounded().has_value());
        EXPECT_FALSE(min(x, y).rounded().has_value());
        EXPECT_FALSE(hull(y, x).rounded().has_value());
        EXPECT_FALSE(where_negative(y, zero, one).rounded().has_value());
      }
    EXPECT_FALSE(sqrt(max(unknown, zero)).rounded().has_value());
    EXPECT_FALSE(min(max(unknown, zero), one).rounded().has_value());  // 0 to 1
    EXPECT_FALSE(T(field(-1.0) * max(unknown, zero)).rounded().has_value());

    // It is a number all the same.
    EXPECT_EQ((zero * unknown).rounded(), 0.0);
    EXPECT_EQ((unknown * zero).rounded(), 0.0);
    EXPECT_EQ(max(five + zero * unknown, zero).rounded(), 5.0);
    EXPECT_EQ(T(zero * max(unknown, zero)).rounded(), 0.0);
    EXPECT_EQ(T(min(unknown, zero) * zero).rounded(), 0.0);
  }
}

TEST(Ball, WhatIsUnknownIsNeverSettled) {
  expect_unknown_to_stay_unknown(Field<Ball>{240});
  expect_unknown_to_stay_unknown(Field<DoubleDouble>{});
}

TEST(Ball, OfWhatIsNoNumberNothingIsKnown) {
  const Field<Ball> field{240};
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                         -std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(field(x).rounded().has_value());
    EXPECT_FALSE(field(x).nearly_rounded().has_value());
    EXPECT_FALSE(max(field(x), field(0.0)).rounded().has_value());
    EXPECT_FALSE(min(field(x), field(0.0)).rounded().has_value());
    EXPECT_FALSE(max(field(x), field(1.0)).nearly_rounded().has_value());
  }
  // Beyond the greatest double, without an upper bound: no double is known to be the nearest.
  const Ball great = field(std::numeric_limits<double>::max()) * field(4.0);
  EXPECT_EQ(great.rounded(), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(max(great, field(1.0) / field(0.0)).rounded().has_value());
}

TEST(Ball, GoesToANeighbourWhereBothEndsDo) {
  const Field<Ball> field{100};
  const double next = std::nextafter(1.0, 2.0);
  const Ball tie = field(1.0) + field(0x1p-53), about_tie = hull(tie - field(0x1p-90), tie + field(0x1p-90));
  EXPECT_FALSE(about_tie.rounded().has_value());
  EXPECT_EQ(about_tie.nearly_rounded(), 1.0);
  EXPECT_EQ(hull(tie, field(next)).nearly_rounded(), next);
  EXPECT_FALSE(hull(field(1.0), field(std::nextafter(next, 2.0))).nearly_rounded().has_value());
  EXPECT_FALSE(hull(field(-1.0), field(1.0)).nearly_rounded().has_value());
  const Ball tiny = field(0x1p-1000) * field(0x1p-100), about_zero = hull(field(0.0) - tiny, tiny);
  EXPECT_EQ(about_zero.nearly_rounded(), 0.0);
  EXPECT_FALSE(std::signbit(*about_zero.nearly_rounded()));
}

TEST(NearestDouble, HandlesMidpointsAndDenormals) {
  EXPECT_EQ(nearest_double(Rational(1) / Rational(3)), 1.0 / 3.0);
  EXPECT_EQ(nearest_double(Rational(1.0) + Rational(0x1p-53)), 1.0);  // tie to even
  EXPECT_EQ(nearest_double(Rational(1.0) + Rational(0x1p-53) + Rational(0x1p-400)), 1.0 + 0x1p-52);
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(nearest_double(Rational(least) * Rational(3) / Rational(4)), least);
  EXPECT_EQ(nearest_double(Rational(least) / Rational(2)), 0);
}

}  // namespace
}  // namespace pcm::reference
