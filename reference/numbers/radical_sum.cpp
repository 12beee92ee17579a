// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/numbers/radical_sum.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <unordered_map>

namespace pcm::reference {
namespace {

constexpr mpfr_prec_t kFirstPrecision = 256;

/// Odd primes, for telling radicands apart.
constexpr std::array<unsigned long, 30> kPrimes = {3,  5,  7,  11, 13, 17, 19, 23, 29, 31,  37,  41,  43,  47,  53,
                                                   59, 61, 67, 71, 73, 79, 83, 89, 97, 101, 103, 107, 109, 113, 127};

/// Equal for radicands b, c > 0 whose product is the square of a rational, and nearly never for others. For each prime
/// p, b = p^k m has the parity of k and, m being free of p, whether m is a square modulo p: two bits that b shares with
/// each c of that kind.
std::uint64_t signature(const Rational& b) {
  CGAL::Gmpz product, rest;
  mpz_mul(product.mpz(), mpq_numref(b.mpq()), mpq_denref(b.mpq()));  // b times a square
  std::uint64_t bits = 0;
  for (const unsigned long p : kPrimes) {
    int residue = mpz_kronecker_ui(product.mpz(), p);
    bool odd = false;
    if (residue == 0) {
      const CGAL::Gmpz prime(p);
      odd = mpz_remove(rest.mpz(), product.mpz(), prime.mpz()) % 2 == 1;
      residue = mpz_kronecker_ui(rest.mpz(), p);
    }
    bits = 4 * bits + (odd ? 2 : 0) + (residue > 0 ? 1 : 0);
  }
  return bits;
}

/// Numbers of one denominator are added first, then sums in pairs, so that neither many terms that cancel nor many
/// denominators make the intermediate sums longer than they must be.
Rational exact_sum(const std::vector<Rational>& numbers) {
  std::map<CGAL::Gmpz, CGAL::Gmpz> numerators;
  for (const Rational& x : numbers) numerators[x.denominator()] += x.numerator();
  std::vector<Rational> sums;
  for (const auto& [denominator, numerator] : numerators) sums.emplace_back(numerator, denominator);
  for (; sums.size() > 1; sums.resize((sums.size() + 1) / 2))
    for (std::size_t i = 0; 2 * i < sums.size(); ++i)
      sums[i] = 2 * i + 1 < sums.size() ? sums[2 * i] + sums[2 * i + 1] : sums[2 * i];
  return sums.empty() ? Rational(0) : sums[0];
}

/// All terms whose radicands differ by rational squares, as coefficients of the root of the first one's.
struct SquareClass {
  Rational radicand;
  std::vector<Rational> coefficients;
};

/// The class of a radicand among those known, and b's root in units of that class's: sqrt(b) = sqrt(b c) / c sqrt(c).
void add_to_class(const Rational& b, const Rational& r, std::vector<SquareClass>& known) {
  for (SquareClass& other : known)
    if (const std::optional<Rational> root = rational_root(b * other.radicand)) {
      other.coefficients.push_back(r * *root / other.radicand);
      return;
    }
  known.push_back({b, {r}});
}

struct Root {
  Rational coefficient;
  Rational radicand;
};

}  // namespace

void RadicalSum::add(const Rational& r, const Rational& b) {
  assert(sign_of(b) >= 0);
  if (sign_of(r) != 0 && sign_of(b) != 0) coefficients_[b].push_back(r);
}

void RadicalSum::add(const Quadratic& c, const Quadratic& t) {
  if (c.sign() == 0 || t.sign() == 0) return;
  if (!t.rational()) {
    nested_.push_back({c, t});
    return;
  }
  add(c.a(), t.a());
  add(c.b(), c.d() * t.a());
}

double RadicalSum::rounded() const {
  std::vector<Rational> rationals;
  std::unordered_map<std::uint64_t, std::vector<SquareClass>> classes;
  for (const auto& [b, rs] : coefficients_) {
    const Rational r = exact_sum(rs);
    if (sign_of(r) == 0) continue;
    if (const std::optional<Rational> root = rational_root(b))
      rationals.push_back(r * *root);
    else
      add_to_class(b, r, classes[signature(b)]);
  }
  const Rational rational_part = exact_sum(rationals);
  std::vector<Root> roots;
  for (const auto& [bits, known] : classes)
    for (const SquareClass& one : known)
      if (const Rational r = exact_sum(one.coefficients); sign_of(r) != 0) roots.push_back({r, one.radicand});
  if (roots.empty() && nested_.empty()) return nearest_double(rational_part);

  const auto enclose = [&](mpfr_prec_t precision) {
    Ball sum(rational_part, precision);
    const Field<Ball> field{precision};
    for (const Root& root : roots) sum = sum + field(root.coefficient) * sqrt(field(root.radicand));
    for (const NestedRoot& root : nested_)
      sum = sum + enclosed(root.coefficient, field) * sqrt(enclosed(root.radicand, field));
    return sum;
  };
  return rounded_number(kFirstPrecision, nested_.empty() ? MPFR_PREC_MAX : kTiePrecision, enclose);
}

}  // namespace pcm::reference
