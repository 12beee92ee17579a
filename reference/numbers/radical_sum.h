// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "reference/numbers/ball.h"
#include "reference/numbers/quadratic.h"

namespace pcm::reference {

/// An enclosure of so many bits that leaves two neighbouring doubles is taken for that of a tie, where no more is
/// known.
inline constexpr mpfr_prec_t kTiePrecision = 4096;

/// A finite sum of square roots r_i sqrt(b_i) with rational r_i and b_i >= 0, rounded correctly whatever it is: zero,
/// half-way between two doubles, or as near to that as it likes.
///
/// Terms whose b_i b_j is the square of a rational are merged. If only a rational is left, it is rounded directly, ties
/// to even, zero as +0. Otherwise the sum is irrational: square roots of rationals none of which is a square, nor any
/// product of two of them, are linearly independent together with 1 over the rationals (A. S. Besicovitch, On the
/// linear independence of fractional powers of integers, J. London Math. Soc. 15, 1940, 3-6). An irrational number is
/// no tie, so an enclosure of rising precision rounds to one double in the end.
///
/// Roots of roots may be added too. For a sum that holds such terms nothing of the kind is proved: where kTiePrecision
/// bits or more leave no more than two neighbouring doubles, it is taken for halfway between these.
///
/// Cost: a few ms for a thousand terms of different radicands.
class RadicalSum {
 public:
  void add(const Rational& r, const Rational& b);
  /// c sqrt(t), t >= 0.
  void add(const Quadratic& c, const Quadratic& t = Quadratic(Rational(1)));

  double rounded() const;

 private:
  struct NestedRoot {
    Quadratic coefficient;
    Quadratic radicand;
  };
  std::map<Rational, std::vector<Rational>> coefficients_;  ///< of each radicand
  std::vector<NestedRoot> nested_;
};

}  // namespace pcm::reference
