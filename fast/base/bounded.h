// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "fast/base/number_vector.h"

/// Floating-point evaluation of a polynomial together with what bounds its error: the filter of a predicate.
namespace pcm::fast {

/// The computed value v of an expression in differences of coordinates, and its magnitude m: the same expression with
/// every term taken absolutely.
///
/// With u = 2^-53, gamma_n = n u / (1 - n u), k the greatest number of roundings on the way to any term (counted by
/// RoundingCount) and M the exact magnitude: |v - exact| <= gamma_k M, by induction over + - * (Higham, Accuracy and
/// Stability of Numerical Algorithms, section 3.1). A product may also underflow, erring by 2^-1075: its magnitude
/// gains kUnderflow, of which even one rounding pays for 2^-1013. The magnitude itself is rounded at most 2 k times, so
/// M <= m / (1 - 2 k u). Hence |v - exact| <= (k + 1) u m, with room for rounding that bound. Where anything overflows
/// m is infinite or NaN, because |v| <= m always, and every comparison with the bound fails.
struct Bounded {
  double value;
  double magnitude;

  static constexpr double kUnderflow = 0x1p-960;
};

inline Bounded operator+(const Bounded& a, const Bounded& b) {
  return {a.value + b.value, a.magnitude + b.magnitude};
}
inline Bounded operator-(const Bounded& a, const Bounded& b) {
  return {a.value - b.value, a.magnitude + b.magnitude};
}
inline Bounded operator*(const Bounded& a, const Bounded& b) {
  return {a.value * b.value, a.magnitude * b.magnitude + Bounded::kUnderflow};
}

template <>
inline Bounded difference<Bounded>(double a, double b) {
  const double value = a - b;
  return {value, std::abs(value)};
}

/// Counts the roundings a term of an expression suffers: evaluate the same expression on it.
struct RoundingCount {
  int count;
};

constexpr RoundingCount operator+(RoundingCount a, RoundingCount b) {
  return {std::max(a.count, b.count) + 1};
}
constexpr RoundingCount operator-(RoundingCount a, RoundingCount b) {
  return a + b;
}
constexpr RoundingCount operator*(RoundingCount a, RoundingCount b) {
  return {a.count + b.count + 1};
}

/// The difference of two points: each component is rounded once.
inline constexpr NumberVector<RoundingCount> kRoundedDifference{{1}, {1}, {1}};

/// The sign of the exact value where floating point is sure of it, else 0. `Roundings`: k of Bounded.
template <int Roundings>
int sure_sign(const Bounded& number) {
  constexpr double kU = 0x1p-53;
  constexpr double kBound = (Roundings + 1) * kU;
  static_assert((Roundings + 1) * (1 - kU) * (1 - Roundings * kU) * (1 - 2 * Roundings * kU) > Roundings,
                "(k + 1) u covers gamma_k, the rounded magnitude and the rounded bound");
  static_assert(kU * Bounded::kUnderflow >= 0x1p-1022, "the bound itself never underflows");
  const double bound = kBound * number.magnitude;
  return (number.value > bound) - (number.value < -bound);
}

}  // namespace pcm::fast
