// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "reference/numbers/numbers.h"

namespace pcm::reference {

/// Of a relative state, resolved in Me (PCM section 1): those of r, a rotation of F about Mf, of v and of w.
struct Coordinate {
  enum class Of : std::uint8_t { position, rotation, velocity, angular_velocity };
  Of of = Of::position;
  int axis = 0;
};

/// A number of kind T, which encloses, and its derivative by one coordinate: forward differentiation. Where min, max or
/// where_negative choose between two numbers, the derivative is that of the one chosen, and encloses both where the
/// enclosures do not tell; at a tie it is that of one side.
template <class T>
struct Dual {
  T value, slope;

  std::optional<int> sign() const { return value.sign(); }

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const T quotient = a.value / b.value;
    return {quotient, (a.slope - quotient * b.slope) / b.value};
  }
  /// At 0 nothing is known of the derivative.
  friend Dual sqrt(const Dual& a) {
    const T root = sqrt(a.value);
    return {root, a.slope / (root + root)};
  }
  friend Dual min(const Dual& a, const Dual& b) { return where_negative(a - b, a, b); }
  friend Dual max(const Dual& a, const Dual& b) { return where_negative(a - b, b, a); }
  /// a where x < 0, otherwise b.
  friend Dual where_negative(const Dual& x, const Dual& a, const Dual& b) {
    return {where_negative(x.value, a.value, b.value), where_negative(x.value, a.slope, b.slope)};
  }
};

/// Makes constants, and knows by which coordinate is differentiated.
template <class T>
struct Field<Dual<T>> {
  Field<T> number;
  Coordinate coordinate;

  template <class Number>
  Dual<T> operator()(const Number& x) const {
    return {number(x), number(0.0)};
  }
};

}  // namespace pcm::reference
