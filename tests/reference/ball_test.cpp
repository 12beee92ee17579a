// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/ball.h"

#include <gtest/gtest.h>

#include <iostream>
#include <limits>
#include <random>

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
