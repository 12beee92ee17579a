// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/numbers/dual.h"

#include <gtest/gtest.h>

#include <limits>

#include "reference/numbers/ball.h"
#include "reference/numbers/double_double.h"

namespace pcm::reference {
namespace {

using Number = Dual<DoubleDouble>;

Number number(double value, double slope) {
  return {DoubleDouble(value), DoubleDouble(slope)};
}

void expect(const Number& x, double value, double slope) {
  EXPECT_EQ(x.value.rounded(), value);
  EXPECT_EQ(x.slope.rounded(), slope);
}

TEST(Dual, HasTheRulesOfDifferentiation) {
  const Number x = number(4, 1), y = number(0.5, -3);
  expect(x + y, 4.5, -2);
  expect(x - y, 3.5, 4);
  expect(x * y, 2, 1 * 0.5 + 4 * -3);
  expect(x / y, 8, (1 * 0.5 - 4 * -3) / 0.25);
  expect(sqrt(x), 2, 0.25);
}

TEST(Dual, OfAChoiceIsThatOfTheOneChosen) {
  const Number x = number(4, 1), y = number(0.5, -3);
  expect(min(x, y), 0.5, -3);
  expect(max(x, y), 4, 1);
  expect(where_negative(number(-1, 7), x, y), 4, 1);
  expect(where_negative(number(0, 7), x, y), 0.5, -3);
}

TEST(Dual, AtATieIsThatOfOneSide) {
  const Number x = number(2, 1), y = number(2, -3);
  expect(min(x, y), 2, -3);
  expect(max(x, y), 2, 1);
}

TEST(Dual, EnclosesBothSlopesWhereTheEnclosureDoesNotTell) {
  const Number third = number(1, 0) / number(3, 0), about_zero = third + third + third - number(1, 0);
  ASSERT_FALSE(about_zero.sign().has_value());
  const NearDouble slope = where_negative(about_zero, number(0, 1), number(0, -1)).slope.nearby();
  EXPECT_GE(slope.value + slope.error, 1);
  EXPECT_LE(slope.value - slope.error, -1);
}

TEST(Dual, OfARootAtZeroIsNotKnown) {
  EXPECT_EQ(sqrt(number(0, 1)).slope.nearby().error, std::numeric_limits<double>::infinity());
  // And is of no interest where it is multiplied by what is 0 all along.
  expect(sqrt(number(0, 1)) * number(0, 0), 0, 0);
}

TEST(NearDouble, IsNoFartherFromTheNumberThanItSays) {
  const Rational third = Rational(1) / Rational(3);
  const NearDouble short_third = DoubleDouble(third).nearby(), long_third = Ball(third, 240).nearby();
  for (const NearDouble& nearby : {short_third, long_third}) {
    EXPECT_NEAR(nearby.value, 1.0 / 3, 1e-15);
    EXPECT_LE(CGAL::abs(Rational(third - Rational(nearby.value))), Rational(nearby.error));
    EXPECT_LT(nearby.error, 1e-16);
  }
  EXPECT_EQ(Ball(0.75, 240).nearby().error, 0);
  EXPECT_EQ(DoubleDouble(0.75).nearby().error, 0);
  EXPECT_EQ((Ball(1.0, 64) / Ball(0.0, 64)).nearby().error, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace pcm::reference
