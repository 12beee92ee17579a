// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/numbers/quadratic.h"

#include <cassert>

namespace pcm::reference {
namespace {

const Rational& common_radicand(const Quadratic& x, const Quadratic& y) {
  assert(x.rational() || y.rational() || x.d() == y.d());
  return x.rational() ? y.d() : x.d();
}

}  // namespace

std::optional<Rational> rational_root(const Rational& x) {
  // Numerator and denominator have no common factor, so each must be a square.
  const mpq_srcptr value = x.mpq();
  if (mpz_perfect_square_p(mpq_numref(value)) == 0 || mpz_perfect_square_p(mpq_denref(value)) == 0) return {};
  CGAL::Gmpz numerator, denominator;
  mpz_sqrt(numerator.mpz(), mpq_numref(value));
  mpz_sqrt(denominator.mpz(), mpq_denref(value));
  return Rational(numerator, denominator);
}

int Quadratic::sign() const {
  const int of_a = sign_of(a_), of_b = sign_of(b_);
  if (of_a * of_b >= 0) return of_a != 0 ? of_a : of_b;
  // Of opposite signs: the greater square decides; they cannot be equal.
  return sign_of(a_ * a_ - b_ * b_ * d_) * of_a;
}

Quadratic operator+(const Quadratic& x, const Quadratic& y) {
  return {x.a_ + y.a_, x.b_ + y.b_, common_radicand(x, y)};
}

Quadratic operator-(const Quadratic& x, const Quadratic& y) {
  return {x.a_ - y.a_, x.b_ - y.b_, common_radicand(x, y)};
}

Quadratic operator*(const Quadratic& x, const Quadratic& y) {
  if (x.rational() && y.rational()) return Quadratic(x.a_ * y.a_);
  const Rational& d = common_radicand(x, y);
  return {x.a_ * y.a_ + x.b_ * y.b_ * d, x.a_ * y.b_ + x.b_ * y.a_, d};
}

Quadratic operator/(const Quadratic& x, const Quadratic& y) {
  assert(y.sign() != 0);
  if (y.rational()) return {x.a_ / y.a_, x.b_ / y.a_, x.d_};
  const Rational norm = y.a_ * y.a_ - y.b_ * y.b_ * y.d_;
  return x * Quadratic(y.a_ / norm, -y.b_ / norm, y.d_);
}

Quadratic sqrt(const Quadratic& x) {
  assert(x.rational() && x.sign() >= 0);
  if (const std::optional<Rational> root = rational_root(x.a_)) return Quadratic(*root);
  return {Rational(0), Rational(1), x.a_};
}

}  // namespace pcm::reference
