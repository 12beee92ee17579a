// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpfr.h>

#include <array>
#include <memory>
#include <optional>

#include "reference/numbers/numbers.h"

namespace pcm::reference {

/// An interval that encloses a real number, with as many bits as asked for: both ends are MPFR numbers, rounded
/// outward. A result has the greater precision of its operands. Precision belongs to each number, so threads do not
/// meet. Ends of up to 256 bits live in the object itself; only finer ones need the heap.
///
/// An end may be infinite, the lower one only to the left and the upper one only to the right: nothing is known on that
/// side. The ends are never NaN, as zero times anything is zero and the whole line is all that is known of a quotient
/// whose divisor may be zero. No enclosure with an infinite end rounds to a double.
class Ball {
 public:
  /// The whole line where x is infinite or no number.
  Ball(double x, mpfr_prec_t precision);
  Ball(const Rational& x, mpfr_prec_t precision);
  Ball(const Ball& x);
  Ball& operator=(const Ball& x);

  friend Ball operator+(const Ball& a, const Ball& b);
  friend Ball operator-(const Ball& a, const Ball& b);
  /// Zero times anything is zero, exactly: every number is finite, though nothing else may be known of it.
  friend Ball operator*(const Ball& a, const Ball& b);
  /// The whole line where b holds 0.
  friend Ball operator/(const Ball& a, const Ball& b);
  /// Of a number known not to be negative: what of the enclosure lies below zero is left out.
  friend Ball sqrt(const Ball& a);
  /// Enclosures of the smaller, of the greater of two numbers, and of either.
  friend Ball min(const Ball& a, const Ball& b);
  friend Ball max(const Ball& a, const Ball& b);
  friend Ball hull(const Ball& a, const Ball& b);
  /// a where x < 0, otherwise b; either where the enclosure of x does not tell.
  friend Ball where_negative(const Ball& x, const Ball& a, const Ball& b);

  /// -1 or 1 where the enclosure lies on one side of zero, 0 where it is zero itself; nothing where it does not tell.
  std::optional<int> sign() const;

  /// The double nearest to the number, where all of the enclosure, being finite, rounds to it; zero is +0.
  std::optional<double> rounded() const;

  /// The double nearest to the middle of the enclosure, where its ends round to one double or to two neighbours: all
  /// that can be had for a number halfway between these.
  std::optional<double> nearly_rounded() const;

  NearDouble nearby() const;

 private:
  static constexpr std::size_t kInlineLimbs = 4;

  /// Room for both ends, which are set to 0.
  explicit Ball(mpfr_prec_t precision);
  void make_room(mpfr_prec_t precision);
  void set_whole_line();
  bool is_finite() const { return mpfr_number_p(lower_) && mpfr_number_p(upper_); }
  /// Room for a result of a and b.
  Ball(const Ball& a, const Ball& b);
  bool not_negative() const { return mpfr_sgn(lower_) >= 0; }
  bool not_positive() const { return mpfr_sgn(upper_) <= 0; }

  std::array<mp_limb_t, 2 * kInlineLimbs> inline_limbs_;
  std::unique_ptr<mp_limb_t[]> heap_limbs_;
  mpfr_t lower_;
  mpfr_t upper_;
};

template <>
struct Field<Ball> {
  mpfr_prec_t precision;
  Ball operator()(double x) const { return Ball(x, precision); }
  Ball operator()(const Rational& x) const { return Ball(x, precision); }
};

/// The double nearest to a number out of enclosures(precision) that close in on it as the precision rises: from `first`
/// bits on, until one rounds to a double or, from `last` bits on, to one of two neighbours.
template <class Enclosures>
double rounded_number(mpfr_prec_t first, mpfr_prec_t last, const Enclosures& enclosures) {
  for (mpfr_prec_t precision = first;; precision *= 2) {
    const Ball enclosure = enclosures(precision);
    const std::optional<double> value = precision < last ? enclosure.rounded() : enclosure.nearly_rounded();
    if (value) return *value;
  }
}

/// The double nearest to a rational number (ties to even), whatever its size; zero is +0.
double nearest_double(const Rational& x);

}  // namespace pcm::reference
