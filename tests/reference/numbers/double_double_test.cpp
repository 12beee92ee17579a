// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/numbers/double_double.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

#include "reference/numbers/ball.h"

namespace pcm::reference {
namespace {

/// An enclosure and the number it is of.
struct Known {
  DoubleDouble enclosure;
  Rational number;
};

class DoubleDoubleOfRandomExpressions : public testing::Test {
 protected:
  explicit DoubleDoubleOfRandomExpressions(std::uint64_t seed = 11) : random_(seed) {
    std::cout << "seed " << seed << "\n";
  }

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  /// Few or many digits, of any sign, sizes from 2^-range to 2^range as far as there are doubles.
  double draw(int range) {
    const int digits = below(2) == 0 ? 4 : 53;
    const auto mantissa = static_cast<double>(static_cast<std::int64_t>(random_()) >> (64 - digits));
    const int exponent = static_cast<int>(below(2 * static_cast<std::size_t>(range) + 1)) - range;
    return std::ldexp(mantissa, std::min(exponent, 1000) - digits);
  }
  Known convert(double x) { return {DoubleDouble(x), Rational(x)}; }
  /// Of two numbers; a quotient only where it is one.
  Known combine(const Known& a, const Known& b) {
    switch (below(7)) {
      case 6: {
        const Known hulled = sign_of(a.number) < 0 ? a : b;
        return {hull(a.enclosure, b.enclosure), hulled.number};
      }
      case 0:
        return {a.enclosure + b.enclosure, Rational(a.number + b.number)};
      case 1:
        return {a.enclosure - b.enclosure, Rational(a.number - b.number)};
      case 2:
        return {min(a.enclosure, b.enclosure), std::min(a.number, b.number)};
      case 3:
        return {max(a.enclosure, b.enclosure), std::max(a.number, b.number)};
      case 4:
        if (sign_of(b.number) != 0) return {a.enclosure / b.enclosure, Rational(a.number / b.number)};
        [[fallthrough]];
      default:
        return {a.enclosure * b.enclosure, Rational(a.number * b.number)};
    }
  }

 private:
  std::mt19937_64 random_;
};

TEST_F(DoubleDoubleOfRandomExpressions, EncloseTheRationalResultAndRoundCorrectlyWhereTheyRound) {
  int settled = 0, all = 0;
  for (const int range : {2, 40, 330, 1070}) {
    for (int trial = 0; trial < 3000; ++trial) {
      std::vector<Known> known;
      for (int i = 0; i < 4; ++i) known.push_back(convert(draw(range)));
      for (int i = 0; i < 6; ++i) {
        // Old ones too, so that terms cancel.
        const Known next = combine(known[below(known.size())], known[below(known.size())]);
        ASSERT_TRUE(next.enclosure.holds(next.number)) << "range " << range << ", trial " << trial;
        if (const std::optional<double> rounded = next.enclosure.rounded()) {
          ASSERT_EQ(*rounded, nearest_double(next.number)) << "range " << range << ", trial " << trial;
          ASSERT_FALSE(*rounded == 0 && std::signbit(*rounded));
          settled += range <= 40 ? 1 : 0;
        }
        if (const std::optional<int> sign = next.enclosure.sign()) {
          ASSERT_EQ(*sign, sign_of(next.number));
        }
        all += range <= 40 ? 1 : 0;
        known.push_back(next);
      }
    }
  }
  EXPECT_GT(settled, 0.7 * all);
}

TEST_F(DoubleDoubleOfRandomExpressions, RootsEncloseTheRootOfASquare) {
  for (const int range : {2, 40, 330, 1070}) {
    for (int trial = 0; trial < 2000; ++trial) {
      const Known a = convert(draw(range)), b = convert(draw(range)), c = combine(a, b);
      const DoubleDouble root = sqrt(c.enclosure * c.enclosure);
      ASSERT_TRUE(root.holds(sign_of(c.number) < 0 ? Rational(-c.number) : c.number))
          << "range " << range << ", trial " << trial;
    }
  }
}

TEST(DoubleDouble, RootsOfWhatAreNoSquaresLieBetweenNumbersWhoseSquaresDoNot) {
  for (const double x : {2.0, 0.1, 1e-300, 3e250, 1 + 0x1p-20}) {
    const DoubleDouble root = sqrt(DoubleDouble(x));
    ASSERT_TRUE(root.rounded().has_value());
    const Rational low(std::nextafter(*root.rounded(), 0)), high(std::nextafter(*root.rounded(), 2 * *root.rounded()));
    EXPECT_TRUE(low * low < Rational(x) && Rational(x) < high * high) << x;
    EXPECT_TRUE((root * root).holds(Rational(x)));
    EXPECT_FALSE(root.holds(low) || root.holds(high));
  }
}

TEST(DoubleDouble, RootOfWhatMayBeZeroLiesBetweenZeroAndTheGreatestRoot) {
  for (const double middle : {0.0, 0x1p-40, 0.001, 0.25, 1.0}) {
    const DoubleDouble root = sqrt(DoubleDouble::near(middle, {0, 1}));
    const double greatest = std::sqrt(middle + 1);
    EXPECT_TRUE(root.holds(Rational(0x1p-30))) << middle;
    EXPECT_TRUE(root.holds(Rational((1 - 0x1p-30) * greatest))) << middle;
    EXPECT_FALSE(root.holds(Rational(-0x1p-30))) << middle;
    EXPECT_FALSE(root.holds(Rational((1 + 0x1p-30) * greatest))) << middle;
  }
}

TEST(DoubleDouble, RationalNumbersAreEnclosedOrExact) {
  const DoubleDouble third(Rational(1) / Rational(3));
  EXPECT_TRUE(third.holds(Rational(1) / Rational(3)));
  EXPECT_EQ((third * DoubleDouble(3.0)).rounded(), 1.0);
  EXPECT_EQ(DoubleDouble(Rational(0)).sign(), 0);
  EXPECT_EQ((DoubleDouble(Rational(1) / Rational(2)) - DoubleDouble(0.5)).sign(), 0);
}

TEST(DoubleDouble, OfANumberNearADoubleHoldsItAndLittleElse) {
  for (int i = 1; i < 200; ++i) {
    const Rational x(i % 2 == 0 ? 1000 + i : -1000 - i, 3 * i);
    const Ball ball(x, 256);
    const double high = ball.nearby().value;
    const DoubleDouble number = DoubleDouble::near(high, (ball - Ball(high, 256)).nearby());
    EXPECT_TRUE(number.holds(x)) << x;
    EXPECT_FALSE(number.holds(Rational(x + x * Rational(0x1p-95)))) << x;
    EXPECT_FALSE(number.holds(Rational(x - x * Rational(0x1p-95)))) << x;
  }
  const NearDouble nothing{0, std::numeric_limits<double>::infinity()};
  EXPECT_TRUE(DoubleDouble::near(1, nothing).holds(Rational(-1e9)));
}

TEST(DoubleDouble, QuotientsAndRootsThatAreDoublesAreExact) {
  EXPECT_EQ((DoubleDouble(1.0) / DoubleDouble(2.0) * DoubleDouble(2.0) - DoubleDouble(1.0)).sign(), 0);
  EXPECT_EQ((sqrt(DoubleDouble(4.0)) - DoubleDouble(2.0)).sign(), 0);
}

TEST(DoubleDouble, HullOfNumbersThatAreNearlyOneKeepsTheirDigits) {
  const DoubleDouble one_third = DoubleDouble(1.0) / DoubleDouble(3.0),
                     two_sixths = DoubleDouble(2.0) / DoubleDouble(6.0);
  const DoubleDouble either = max(one_third, two_sixths);
  EXPECT_TRUE(either.holds(Rational(1) / Rational(3)));
  EXPECT_FALSE(either.holds(Rational(1) / Rational(3) + Rational(0x1p-95)));
}

TEST(DoubleDouble, RootOfAnEnclosureThatReachesBelowZeroStartsAtZero) {
  const DoubleDouble root = sqrt(hull(DoubleDouble(-1.0), DoubleDouble(4.0)));
  EXPECT_TRUE(root.holds(Rational(0)));
  EXPECT_TRUE(root.holds(Rational(2)));
}

TEST(DoubleDouble, ZeroStaysExactlyZero) {
  const DoubleDouble zero(0.0), third = DoubleDouble(1.0) / DoubleDouble(3.0);
  EXPECT_EQ((zero * third).sign(), 0);
  EXPECT_EQ((zero / third).sign(), 0);
  EXPECT_EQ(sqrt(zero).sign(), 0);
  EXPECT_EQ((DoubleDouble(0.1) * DoubleDouble(0.3) - DoubleDouble(0.3) * DoubleDouble(0.1)).rounded().value_or(1), 0);
  EXPECT_FALSE(std::signbit(*(zero * DoubleDouble(-1.0)).rounded()));
}

TEST(DoubleDouble, HighPartsThatCancelLeaveTheLowOnesInFull) {
  const double low = 0x1p-60 * (1 + 0x1p-52);
  const DoubleDouble a = DoubleDouble(1.0) + DoubleDouble(low), b = DoubleDouble(1.0) - DoubleDouble(0x1p-130);
  EXPECT_TRUE((a - b).holds(Rational(low) + Rational(0x1p-130)));
}

TEST(DoubleDouble, RoundsNextToATieButNotWhereTheEnclosureHoldsIt) {
  const DoubleDouble tie = DoubleDouble(1.0) + DoubleDouble(0x1p-53);
  EXPECT_EQ(tie.rounded(), 1.0);  // exact: to even
  const DoubleDouble one = DoubleDouble(3.0) * (DoubleDouble(1.0) / DoubleDouble(3.0));
  EXPECT_EQ(one.rounded(), 1.0);
  EXPECT_FALSE((one + DoubleDouble(0x1p-53)).rounded().has_value());
  EXPECT_EQ((one + DoubleDouble(0x1p-53) + DoubleDouble(0x1p-90)).rounded(), 1 + 0x1p-52);
  EXPECT_EQ((one + DoubleDouble(0x1p-53) - DoubleDouble(0x1p-90)).rounded(), 1.0);
}

TEST(DoubleDouble, NothingIsKnownOfWhatOverflowsOrIsDividedByWhatMayBeZero) {
  const DoubleDouble one(1.0), huge(1e308);
  EXPECT_FALSE((huge * huge).rounded().has_value());
  EXPECT_FALSE((huge + huge).rounded().has_value());
  EXPECT_FALSE((huge * huge).sign().has_value());
  EXPECT_FALSE((one / DoubleDouble(0.0)).rounded().has_value());
  EXPECT_FALSE((one / hull(DoubleDouble(-1.0), one)).sign().has_value());
  EXPECT_FALSE(((huge * huge) - (huge * huge)).rounded().has_value());
  EXPECT_FALSE(sqrt(huge * huge).rounded().has_value());
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_TRUE((DoubleDouble(least) * DoubleDouble(0.5)).holds(Rational(least) / Rational(2)));
  EXPECT_FALSE((DoubleDouble(least) * DoubleDouble(0.5)).sign().has_value());
}

}  // namespace
}  // namespace pcm::reference
