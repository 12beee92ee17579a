// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/brute_force/rational.h"

#include <mpfr.h>

#include <optional>

namespace pcm::brute_force {
namespace {

constexpr mpfr_prec_t kPrecision = 4000;

/// The root of a rational square, or nothing.
std::optional<Rational> rational_root(const Rational& value) {
  if (mpz_perfect_square_p(value.get_num_mpz_t()) == 0 || mpz_perfect_square_p(value.get_den_mpz_t()) == 0) return {};
  const mpz_class numerator = sqrt(value.get_num());
  const mpz_class denominator = sqrt(value.get_den());
  return Rational(numerator, denominator);
}

}  // namespace

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(const Rational& s, const Vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
Rational dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double rounded(const Rational& value) {
  mpfr_t nearest;
  mpfr_init2(nearest, 53);
  mpfr_set_q(nearest, value.get_mpq_t(), MPFR_RNDN);
  const double result = mpfr_get_d(nearest, MPFR_RNDN);
  mpfr_clear(nearest);
  return result;
}

double rounded(const std::vector<Root>& sum) {
  Rational rational_part = 0;
  std::vector<Root> classes;  // one term for each class of radicands modulo rational squares
  for (const Root& term : sum) {
    if (term.coefficient == 0 || term.radicand == 0) continue;
    if (const auto root = rational_root(term.radicand)) {
      rational_part += term.coefficient * *root;
      continue;
    }
    bool merged = false;
    for (Root& other : classes) {
      // sqrt(b) = sqrt(b c) / c * sqrt(c).
      const auto root = rational_root(Rational(term.radicand * other.radicand));
      if (!root) continue;
      other.coefficient += term.coefficient * *root / other.radicand;
      merged = true;
      break;
    }
    if (!merged) classes.push_back(term);
  }
  std::erase_if(classes, [](const Root& term) { return term.coefficient == 0; });
  if (classes.empty()) return rounded(rational_part);

  mpfr_t total;
  mpfr_t term_value;
  mpfr_inits2(kPrecision, total, term_value, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_q(total, rational_part.get_mpq_t(), MPFR_RNDN);
  for (const Root& term : classes) {
    mpfr_set_q(term_value, term.radicand.get_mpq_t(), MPFR_RNDN);
    mpfr_sqrt(term_value, term_value, MPFR_RNDN);
    mpfr_mul_q(term_value, term_value, term.coefficient.get_mpq_t(), MPFR_RNDN);
    mpfr_add(total, total, term_value, MPFR_RNDN);
  }
  const double result = mpfr_get_d(total, MPFR_RNDN);
  mpfr_clears(total, term_value, static_cast<mpfr_ptr>(nullptr));
  return result;
}

}  // namespace pcm::brute_force
