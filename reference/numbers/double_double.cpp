// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/numbers/double_double.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "reference/numbers/ball.h"

namespace pcm::reference {
namespace {

/// Asked of an addition: std::fegetround tells of the x87 unit, which guards leave as the host has it.
[[maybe_unused]] bool rounds_to_nearest() {
  const volatile double one = 1, small = 0x1p-54;
  return one + small == 1 && one - small == 1;
}

}  // namespace

DoubleDouble::DoubleDouble(const Rational& x) : DoubleDouble(unknown()) {
  const double high = nearest_double(x);
  if (!(std::abs(high) < kInfinity)) return;
  const double low = nearest_double(Rational(x - Rational(high)));
  const bool exact = Rational(high) + Rational(low) == x;
  *this = made_of(high, low, exact ? 0 : kRelativeError * std::abs(high) + kUnderflow);
}

// |a / b - q| = |a - b q| / |b|.
DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double least = b.least();
  if (!(least > 0)) return DoubleDouble::unknown();
  if (a.is_zero()) return a;
  const double first = a.high_ / b.high_;
  const double second = (a - b * DoubleDouble(first)).high_ / b.high_;
  const DoubleDouble q = DoubleDouble::made_of(first, second, 0);
  const DoubleDouble rest = a - b * q;
  if (rest.is_zero()) return q;
  return DoubleDouble::made_of(q.high_, q.low_,
                               DoubleDouble::kUp * (rest.greatest() / least) + DoubleDouble::kUnderflow);
}

// |sqrt(a) - q| = |a - q^2| / (sqrt(a) + q).
DoubleDouble sqrt(const DoubleDouble& a) {
  if (!(a.radius_ < DoubleDouble::kInfinity)) return DoubleDouble::unknown();
  if (!(a.least() > 0 && a.high_ > 0)) {
    const double half = 0.5 * DoubleDouble::kUp * std::sqrt(a.greatest());
    return DoubleDouble::made_of(half, 0, DoubleDouble::kUp * half);
  }
  const double first = std::sqrt(a.high_);
  const double second = (a - DoubleDouble(first) * DoubleDouble(first)).high_ / (2 * first);
  const DoubleDouble q = DoubleDouble::made_of(first, second, 0);
  const DoubleDouble rest = a - q * q;
  if (rest.is_zero()) return q;
  return DoubleDouble::made_of(q.high_, q.low_,
                               DoubleDouble::kUp * (rest.greatest() / q.least()) + DoubleDouble::kUnderflow);
}

DoubleDouble hull(const DoubleDouble& a, const DoubleDouble& b) {
  const auto half = [](const DoubleDouble& x) { return DoubleDouble(0.5 * x.high_, 0.5 * x.low_, 0); };
  DoubleDouble middle = half(a) + half(b);
  middle.radius_ = 0;  // Any point between will do.
  return DoubleDouble::made_of(middle.high_, middle.low_, std::max((a - middle).greatest(), (b - middle).greatest()));
}

// Rounding is monotonic: what lies between two numbers that round to one double does so, too.
std::optional<double> DoubleDouble::rounded() const {
  assert(rounds_to_nearest());
  if (radius_ == 0) return high_ + 0.0;  // -0 turns into +0
  const auto outward = [](double x, double way) { return x + way * 0x1p-52 * std::abs(x); };
  const double lower = high_ + outward(low_ - radius_, -1), upper = high_ + outward(low_ + radius_, 1);
  if (lower == upper) return lower + 0.0;
  return {};
}

bool DoubleDouble::holds(const Rational& x) const {
  if (!(radius_ < kInfinity)) return true;
  return CGAL::abs(Rational(x - Rational(high_) - Rational(low_))) <= Rational(radius_);
}

}  // namespace pcm::reference
