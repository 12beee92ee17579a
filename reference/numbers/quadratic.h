// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "reference/numbers/numbers.h"

namespace pcm::reference {

/// The root of a rational number that is the square of one; nothing otherwise. x >= 0.
std::optional<Rational> rational_root(const Rational& x);

/// a + b sqrt(d), a number of the field Q(sqrt d): exact, its sign too. Where b != 0, d > 0 is no square of a rational.
/// Two numbers meet in one operation only if their d are equal or one of them is rational.
class Quadratic {
 public:
  explicit Quadratic(const Rational& a = Rational(0)) : a_(a) {}

  const Rational& a() const { return a_; }
  const Rational& b() const { return b_; }
  const Rational& d() const { return d_; }
  bool rational() const { return sign_of(b_) == 0; }
  int sign() const;

  friend Quadratic operator+(const Quadratic& x, const Quadratic& y);
  friend Quadratic operator-(const Quadratic& x, const Quadratic& y);
  friend Quadratic operator*(const Quadratic& x, const Quadratic& y);
  /// y must not be 0.
  friend Quadratic operator/(const Quadratic& x, const Quadratic& y);
  /// Of a rational number that is not negative.
  friend Quadratic sqrt(const Quadratic& x);
  friend Quadratic min(const Quadratic& x, const Quadratic& y) { return (x - y).sign() < 0 ? x : y; }
  friend Quadratic max(const Quadratic& x, const Quadratic& y) { return (x - y).sign() < 0 ? y : x; }
  /// a where x < 0, otherwise b.
  friend Quadratic where_negative(const Quadratic& x, const Quadratic& a, const Quadratic& b) {
    return x.sign() < 0 ? a : b;
  }

 private:
  Quadratic(const Rational& a, const Rational& b, const Rational& d) : a_(a), b_(b), d_(d) {}

  Rational a_;
  Rational b_ = 0;
  Rational d_ = 0;
};

/// Encloses a + b sqrt(d).
template <class T>
T enclosed(const Quadratic& x, const Field<T>& field) {
  const T a = field(x.a());
  return x.rational() ? a : a + field(x.b()) * sqrt(field(x.d()));
}

template <>
struct Field<Quadratic> {
  Quadratic operator()(double x) const { return Quadratic(Rational(x)); }
  Quadratic operator()(const Rational& x) const { return Quadratic(x); }
};

}  // namespace pcm::reference
