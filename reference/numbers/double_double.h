// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cfloat>
#include <cmath>
#include <limits>
#include <optional>

#include "meshes/base/floating_point_policy.h"
#include "reference/numbers/numbers.h"

namespace pcm::reference {

static_assert(FLT_EVAL_METHOD == 0, "sums and products of doubles must be rounded to doubles");

/// An interval that encloses a real number to some 100 bits: the unevaluated sum high + low of two doubles, high being
/// the double nearest to that sum, and a radius, 0 where the number is known exactly. A filter before Ball, at a tenth
/// of its cost. Rounding must be to nearest.
///
/// Sums and products are double-word arithmetic: M. Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error bounds
/// for basic building blocks of double-word arithmetic, ACM Trans. Math. Softw. 44 (2017), algorithms 6 and 12, within
/// 3 u^2 and 5 u^2 of the result, u = 2^-53, where nothing under- or overflows. Quotients and roots are enclosed by
/// what is left when they are put to the test. What overflows is nothing known: the whole line.
class DoubleDouble {
 public:
  /// Exactly x, which is finite.
  explicit DoubleDouble(double x) : DoubleDouble(x, 0, 0) {}
  explicit DoubleDouble(const Rational& x);
  /// high + rest.value, off by rest.error at most; |high| >= |rest.value|.
  static DoubleDouble near(double high, const NearDouble& rest) {
    assert(!(std::abs(high) < std::abs(rest.value)));
    return made_of(high, rest.value, rest.error);
  }

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b);
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + DoubleDouble(-b.high_, -b.low_, b.radius_);
  }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b);
  /// The whole line where b holds 0.
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b);
  /// Of a number known not to be negative: what of the enclosure lies below zero is left out.
  friend DoubleDouble sqrt(const DoubleDouble& a);
  /// Enclosures of the smaller, of the greater of two numbers, and of either.
  friend DoubleDouble min(const DoubleDouble& a, const DoubleDouble& b) { return where_negative(a - b, a, b); }
  friend DoubleDouble max(const DoubleDouble& a, const DoubleDouble& b) { return where_negative(a - b, b, a); }
  friend DoubleDouble hull(const DoubleDouble& a, const DoubleDouble& b);
  /// a where x < 0, otherwise b; either where the enclosure of x does not tell.
  friend DoubleDouble where_negative(const DoubleDouble& x, const DoubleDouble& a, const DoubleDouble& b) {
    const std::optional<int> sign = x.sign();
    if (!sign) return hull(a, b);
    return *sign < 0 ? a : b;
  }

  /// -1 or 1 where the enclosure lies on one side of zero, 0 where it is zero itself; nothing where it does not tell.
  std::optional<int> sign() const {
    if (high_ == 0 && radius_ == 0) return 0;
    if (!(least() > 0)) return {};
    return high_ > 0 ? 1 : -1;
  }

  /// The double nearest to the number, where all of the enclosure rounds to it; zero is +0.
  std::optional<double> rounded() const;

  /// How far the number is from high + low at most.
  double radius() const { return radius_; }

  NearDouble nearby() const { return {high_, kUp * (std::abs(low_) + radius_)}; }

  /// Whether x lies in the enclosure, decided exactly.
  bool holds(const Rational& x) const;

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  /// Pays for a few roundings of radii, and of bounds.
  static constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;
  /// Of a sum or a product, or of a rational number in two doubles, with room to spare; and more than any number of
  /// underflows in one operation make.
  static constexpr double kRelativeError = 0x1p-100, kUnderflow = 0x1p-1060;

  DoubleDouble(double high, double low, double radius) : high_(high), low_(low), radius_(radius) {}
  static DoubleDouble unknown() { return {0, 0, kInfinity}; }
  /// high + low +- radius, where these are numbers; |high| >= |low|.
  static DoubleDouble made_of(double high, double low, double radius) {
    const double sum = high + low;
    const DoubleDouble made(sum, low - (sum - high), radius);
    return std::abs(sum) < kInfinity && radius < kInfinity ? made : unknown();
  }
  bool is_double() const { return low_ == 0 && radius_ == 0; }
  bool is_zero() const { return high_ == 0 && is_double(); }
  /// Bounds of the number's size; no more than 0 where it may be 0.
  double least() const { return kDown * (kDown * std::abs(high_) - radius_); }
  double greatest() const { return kUp * (kUp * std::abs(high_) + radius_); }

  double high_, low_, radius_;
};

template <>
struct Field<DoubleDouble> {
  DoubleDouble operator()(double x) const { return DoubleDouble(x); }
  DoubleDouble operator()(const Rational& x) const { return DoubleDouble(x); }
};

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const auto two_sum = [](double x, double y, double& sum) {
    sum = x + y;
    const double y_part = sum - x;
    return (x - (sum - y_part)) + (y - y_part);
  };
  double s = 0, t = 0;
  const double s_low = two_sum(a.high_, b.high_, s);
  if (a.is_double() && b.is_double()) return DoubleDouble::made_of(s, s_low, 0);
  const double t_low = two_sum(a.low_, b.low_, t);
  const double c = s_low + t, v = s + c, v_low = c - (v - s), w = t_low + v_low;
  return DoubleDouble::made_of(
      v, w, DoubleDouble::kUp * (a.radius_ + b.radius_ + DoubleDouble::kRelativeError * (std::abs(v) + std::abs(w))));
}

// Zero times anything is zero, exactly.
inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  if (a.is_zero() || b.is_zero()) return DoubleDouble(0.0);
  const double high = a.high_ * b.high_, rest = std::fma(a.high_, b.high_, -high);
  if (a.is_double() && b.is_double() && std::abs(high) > 0x1p-900) return DoubleDouble::made_of(high, rest, 0);
  const double low = rest + std::fma(a.low_, b.high_, std::fma(a.high_, b.low_, a.low_ * b.low_));
  return DoubleDouble::made_of(high, low,
                               DoubleDouble::kUp * (a.greatest() * b.radius_ + a.radius_ * b.greatest() +
                                                    DoubleDouble::kRelativeError * std::abs(high)) +
                                   DoubleDouble::kUnderflow);
}

}  // namespace pcm::reference
