// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

/// Plain GMP rationals and what the twin needs of vectors over them. No filters, no lazy evaluation.
namespace pcm::brute_force {

using Rational = mpq_class;
using Vector = std::array<Rational, 3>;

Vector operator+(const Vector& a, const Vector& b);
Vector operator-(const Vector& a, const Vector& b);
Vector operator*(const Rational& s, const Vector& a);
Rational dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);

/// The real number coefficient * sqrt(radicand), radicand >= 0: every area, penetration and force component is a sum of
/// such numbers (an area is half of the root of N . N).
struct Root {
  Rational coefficient;
  Rational radicand = 1;
};

/// The double nearest to the sum. Terms whose radicands differ by a rational square are merged first, so a sum that is
/// rational is rounded directly and an exact zero is zero; what is left is irrational, hence no tie, and is rounded
/// from 4000 bits.
double rounded(const std::vector<Root>& sum);
double rounded(const Rational& value);

}  // namespace pcm::brute_force
