// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/verify/bounds/bound_arithmetic.h"

namespace pcm::compare {

/// A number, and how far at most the true one and a straightforward evaluation of it may be from its value: running
/// error analysis (J. H. Wilkinson; N. J. Higham, Accuracy and Stability of Numerical Algorithms, section 3.3). Every
/// operation counts for kRoundings of them, as an evaluation in another order may take that many.
struct UncertainNumber {
  double value = 0;
  double error = 0;  ///< infinite: nothing is known

  static constexpr double kRoundings = 4;

  UncertainNumber() = default;
  /// Exactly x, or within an error of it.
  explicit UncertainNumber(double x, double most = 0) : value(x), error(most) {
    if (std::isfinite(x) && std::isfinite(most)) return;
    value = 0;
    error = std::numeric_limits<double>::infinity();
  }

  friend UncertainNumber operator+(const UncertainNumber& a, const UncertainNumber& b) {
    return rounded(a.value + b.value, a.error + b.error);
  }
  friend UncertainNumber operator-(const UncertainNumber& a, const UncertainNumber& b) {
    return rounded(a.value - b.value, a.error + b.error);
  }
  friend UncertainNumber operator-(const UncertainNumber& a) { return UncertainNumber(-a.value, a.error); }
  friend UncertainNumber operator*(const UncertainNumber& a, const UncertainNumber& b) {
    if (a.is_zero() || b.is_zero()) return UncertainNumber();
    return rounded(a.value * b.value, times(std::abs(a.value), b.error) + times(a.error, std::abs(b.value)) +
                                          times(a.error, b.error) + kUnderflow);
  }
  friend UncertainNumber operator/(const UncertainNumber& a, const UncertainNumber& b) {
    if (a.is_zero()) return UncertainNumber();
    const double least = std::abs(b.value) - b.error;
    if (!(least > 0)) return nothing_known();
    const double quotient = a.value / b.value;
    return rounded(quotient, (a.error + times(std::abs(quotient), b.error)) / least + kUnderflow);
  }
  static UncertainNumber nothing_known() { return UncertainNumber(0, std::numeric_limits<double>::infinity()); }

  /// Whatever it is, it is 0.
  bool is_zero() const { return value == 0 && error == 0; }
  bool surely_below(double limit) const { return value + error < limit; }
  bool surely_from(double limit) const { return value - error >= limit; }

 private:
  static UncertainNumber rounded(double value, double error) {
    return UncertainNumber(value, error + kRoundings * kRoundoff * (std::abs(value) + error));
  }
};

/// Either of them.
inline UncertainNumber hull(const UncertainNumber& a, const UncertainNumber& b) {
  const double middle = 0.5 * a.value + 0.5 * b.value;
  return UncertainNumber(middle, std::max(std::abs(a.value - middle) + a.error, std::abs(b.value - middle) + b.error));
}

/// Where x < limit the first, else the second; both where x does not tell.
inline UncertainNumber where_below(const UncertainNumber& x, double limit, const UncertainNumber& below,
                                   const UncertainNumber& from) {
  if (x.surely_below(limit)) return below;
  return x.surely_from(limit) ? from : hull(below, from);
}

}  // namespace pcm::compare
