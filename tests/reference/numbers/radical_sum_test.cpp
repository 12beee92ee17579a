// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/numbers/radical_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <tuple>

namespace pcm::reference {
namespace {

Rational power_of_two(int exponent) {
  return Rational(std::ldexp(1.0, exponent));
}

TEST(Quadratic, FieldOperationsUndoEachOther) {
  std::mt19937_64 random(17);
  const auto draw = [&random] { return Rational(static_cast<int>(random() % 41) - 20) / Rational(7); };
  for (int i = 0; i < 200; ++i) {
    const Quadratic root = sqrt(Quadratic(Rational(i % 2 == 0 ? 3 : 25) / Rational(4)));
    const Quadratic x = Quadratic(draw()) + Quadratic(draw()) * root;
    const Quadratic y = Quadratic(draw()) + Quadratic(draw()) * root;
    EXPECT_EQ((x + y - y - x).sign(), 0);
    EXPECT_EQ((x * y - y * x).sign(), 0);
    if (y.sign() != 0) {
      EXPECT_EQ((x / y * y - x).sign(), 0);
    }
    const std::optional<int> enclosed_sign = enclosed(x, Field<Ball>{200}).sign();
    EXPECT_TRUE(!enclosed_sign || *enclosed_sign == x.sign());
  }
}

TEST(Quadratic, RootOfASquareIsRational) {
  EXPECT_TRUE(sqrt(Quadratic(Rational(9) / Rational(49))).rational());
  EXPECT_FALSE(sqrt(Quadratic(Rational(9) / Rational(50))).rational());
  EXPECT_EQ(rational_root(Rational(0)), Rational(0));
}

TEST(RadicalSum, OfNothingIsPlusZero) {
  EXPECT_EQ(RadicalSum().rounded(), 0);
  EXPECT_FALSE(std::signbit(RadicalSum().rounded()));
}

TEST(RadicalSum, ClassesOfRadicandsAreMerged) {
  // sqrt 8 + sqrt 18 - sqrt 50 = (2 + 3 - 5) sqrt 2, and the same with sqrt(9/50) = 3/10 sqrt 2.
  RadicalSum zero;
  zero.add(Rational(1), Rational(8));
  zero.add(Rational(1), Rational(18));
  zero.add(Rational(-1), Rational(50));
  EXPECT_EQ(zero.rounded(), 0);
  EXPECT_FALSE(std::signbit(zero.rounded()));
  zero.add(Rational(-1), Rational(2));
  zero.add(Rational(10) / Rational(3), Rational(9) / Rational(50));
  EXPECT_EQ(zero.rounded(), 0);
  zero.add(power_of_two(-1000), Rational(2));
  EXPECT_EQ(zero.rounded(), std::ldexp(std::sqrt(2.0), -1000));
}

TEST(RadicalSum, RadicandsWithOddAndEvenPowersOfTheFilterPrimesAreToldApart) {
  // b and 9 b are of one class, b and 3 b are not, whatever powers of 3 b itself holds.
  for (const int b : {2, 6, 18, 54, 127, 381}) {
    RadicalSum same, other;
    same.add(Rational(3), Rational(b));
    same.add(Rational(-1), Rational(9 * b));
    EXPECT_EQ(same.rounded(), 0) << b;
    other.add(Rational(1), Rational(b));
    other.add(Rational(-1), Rational(3 * b));
    EXPECT_NEAR(other.rounded(), std::sqrt(b) - std::sqrt(3.0 * b), 1e-14) << b;
  }
}

TEST(RadicalSum, TiesGoToEvenAndTheLeastMoreOrLessDecidesThem) {
  const Rational below_odd = Rational(1) + power_of_two(-53), above_odd = Rational(1) + Rational(3) * power_of_two(-53);
  for (const auto& [tie, down, up] : {std::tuple{below_odd, 1.0, 1 + 0x1p-52}, {above_odd, 1 + 0x1p-52, 1 + 0x1p-51}}) {
    for (const int tiny : {-1, 0, 1}) {
      RadicalSum sum;  // the tie as a sum that only merging shows to be rational
      sum.add(tie, Rational(1));
      sum.add(Rational(3), Rational(7));
      sum.add(Rational(-1), Rational(63));
      sum.add(Rational(tiny) * power_of_two(-1000) * power_of_two(-1000), Rational(3));
      const double even = std::fmod(down, 0x1p-51) == 0 ? down : up;
      EXPECT_EQ(sum.rounded(), tiny < 0 ? down : tiny > 0 ? up : even);
    }
  }
}

TEST(RadicalSum, IrrationalSumsNearlyCancelling) {
  // sqrt(n^2 + 1) - n = 1 / (sqrt(n^2 + 1) + n): about 1 / (2 n).
  const Rational n = power_of_two(600);
  RadicalSum sum;
  sum.add(Rational(1), n * n + Rational(1));
  sum.add(-n, Rational(1));
  EXPECT_EQ(sum.rounded(), std::ldexp(1.0, -601));
}

TEST(RadicalSum, ShuffledTermsOfManyClassesCancel) {
  const std::uint64_t seed = 23;
  std::cout << "seed " << seed << "\n";
  std::mt19937_64 random(seed);
  const auto draw = [&random](int size) { return Rational(1 + static_cast<int>(random() % size)); };
  for (int i = 0; i < 20; ++i) {
    RadicalSum zero;
    for (int j = 0; j < 100; ++j) {
      const Rational b = draw(1000) / draw(1000), scale = draw(1000) / draw(1000), part = draw(99) / Rational(100);
      const Rational r = draw(1000) / draw(1000);
      zero.add(r * part, b);
      zero.add(-r / scale, b * scale * scale);
      zero.add(r * (Rational(1) - part), b);
    }
    EXPECT_EQ(zero.rounded(), 0);
    zero.add(Rational(5), Rational(9) / Rational(49));
    EXPECT_EQ(zero.rounded(), 15.0 / 7);
  }
}

TEST(RadicalSum, RootsOfRootsAreEnclosed) {
  // (1 + sqrt 2) sqrt(3 - 2 sqrt 2) = 1, as 3 - 2 sqrt 2 = (sqrt 2 - 1)^2: not known to be rational, but told so well
  // that the middle is right.
  const Quadratic root = sqrt(Quadratic(Rational(2)));
  RadicalSum one;
  one.add(Quadratic(Rational(1)) + root, Quadratic(Rational(3)) - Quadratic(Rational(2)) * root);
  EXPECT_EQ(one.rounded(), 1);
  one.add(Rational(-1), Rational(1));
  EXPECT_EQ(one.rounded(), 0);
}

}  // namespace
}  // namespace pcm::reference
