// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "meshes/exact/dyadic.h"
#include "tests/fast/exact_numbers.h"

namespace pcm {
namespace {

using fast::Doubles;

/// The same random expression in both number types: a polynomial of degree `degree` at most.
struct Twin {
  Dyadic dyadic;
  mpq_class rational;
};

Twin random_polynomial(int degree, Doubles& doubles, const std::function<double()>& draw) {
  if (degree == 1) {
    const double a = draw(), b = draw();
    const Twin leaf{Dyadic(a), mpq_class(a)};
    if (doubles.integer(0, 1) == 0) return leaf;
    return {leaf.dyadic - Dyadic(b), leaf.rational - mpq_class(b)};
  }
  const auto split = static_cast<int>(doubles.integer(1, degree - 1));
  const Twin a = random_polynomial(split, doubles, draw);
  const Twin b = random_polynomial(degree - split, doubles, draw);
  const Twin c = random_polynomial(degree - 1, doubles, draw);
  const Twin product{a.dyadic * b.dyadic, a.rational * b.rational};
  switch (doubles.integer(0, 3)) {
    case 0:
      return product;
    case 1:
      return {product.dyadic + c.dyadic, product.rational + c.rational};
    case 2:
      return {c.dyadic - product.dyadic, c.rational - product.rational};
    default:
      return {-product.dyadic, -product.rational};
  }
}

/// Equality is tested through the sign of the difference, rebuilt from GMP's value limb by limb.
void expect_equal(const Twin& twin) {
  ASSERT_EQ(twin.dyadic.sign(), sgn(twin.rational));
  // Subtract the leading doubles one after the other; what is left must vanish.
  Dyadic rest = twin.dyadic;
  mpq_class left = twin.rational;
  for (int i = 0; i < 400 && sgn(left) != 0; ++i) {
    const double lead = left.get_d();
    if (lead == 0 || !std::isfinite(lead)) return;  // beyond double's range only the sign is compared
    rest = rest - Dyadic(lead);
    left -= mpq_class(lead);
    ASSERT_EQ(rest.sign(), sgn(left));
  }
}

TEST(Dyadic, PolynomialsOfDegreeSevenAgreeWithRationals) {
  Doubles doubles(20031);
  for (int i = 0; i < 3000; ++i) {
    const auto kind = doubles.integer(0, 5);
    const auto draw = [&]() -> double {
      switch (kind) {
        case 0:
          return doubles.any();
        case 1:
          return doubles.scaled(300);
        case 2:
          return doubles.small_integer(3);
        case 3:
          return doubles.denormal();
        case 4:
          return doubles.extreme();
        default:
          return doubles.unit();
      }
    };
    expect_equal(random_polynomial(static_cast<int>(doubles.integer(1, Dyadic::kDegree)), doubles, draw));
    if (HasFatalFailure()) return;
  }
}

TEST(Dyadic, ExtremeDoublesMultiplyToTheCapacity) {
  const double greatest = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  const Dyadic widest = Dyadic(greatest) - Dyadic(-least);
  const mpq_class widest_rational = mpq_class(greatest) + mpq_class(least);
  Dyadic product = widest;
  mpq_class product_rational = widest_rational;
  for (int i = 1; i < Dyadic::kDegree; ++i) {
    product = product * widest;
    product_rational *= widest_rational;
  }
  for (int i = 0; i < 20; ++i) product = product + product;
  // 2^20 times the product, less 2^20 times the product written with its factors in halves: (w^3)(w^4).
  const Dyadic third = widest * widest * widest;
  Dyadic again = third * (third * widest);
  EXPECT_EQ(sign_of_difference(product, again), 1);
  for (int i = 0; i < 20; ++i) again = again + again;
  EXPECT_EQ(sign_of_difference(product, again), 0);
  EXPECT_EQ((product - again).sign(), 0);
  EXPECT_GT(product.size(), 220);
}

TEST(Dyadic, DoublesComeBackUnchanged) {
  Doubles doubles(7);
  for (int i = 0; i < 20000; ++i) {
    const double x = doubles.any();
    EXPECT_EQ(Dyadic(x).approximate(), x);
    EXPECT_LE(Dyadic(x).size(), 2);
  }
  EXPECT_EQ(Dyadic(0.0).sign(), 0);
  EXPECT_EQ(Dyadic(-0.0).sign(), 0);
  EXPECT_EQ(Dyadic(-std::numeric_limits<double>::denorm_min()).sign(), -1);
}

TEST(Dyadic, ApproximationIsWithinAFewUlps) {
  Doubles doubles(8);
  for (int i = 0; i < 2000; ++i) {
    const Twin twin = random_polynomial(4, doubles, [&] { return doubles.scaled(20); });
    const double expected = twin.rational.get_d();
    EXPECT_NEAR(twin.dyadic.approximate(), expected, 4 * std::abs(expected) * 0x1p-52);
  }
}

TEST(Dyadic, ComparisonIsTheSignOfTheDifference) {
  Doubles doubles(9);
  for (int i = 0; i < 2000; ++i) {
    const double scale = doubles.scaled(3);
    const Twin a = random_polynomial(2, doubles, [&] { return doubles.small_integer(2) * scale; });
    const Twin b = random_polynomial(2, doubles, [&] { return doubles.small_integer(2) * scale; });
    EXPECT_EQ(sign_of_difference(a.dyadic, b.dyadic), cmp(a.rational, b.rational) > 0   ? 1
                                                      : cmp(a.rational, b.rational) < 0 ? -1
                                                                                        : 0);
    EXPECT_EQ(sign_of_difference(b.dyadic, a.dyadic), -sign_of_difference(a.dyadic, b.dyadic));
  }
}

}  // namespace
}  // namespace pcm
