// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpfi.h>

#include <optional>

#include "reference/numbers.h"

namespace pcm::reference {

/// An interval that encloses a real number, with as many bits as asked for. A result has the greatest precision of its
/// operands. Precision belongs to each number, so threads do not meet.
class Ball {
 public:
  explicit Ball(double x, mpfr_prec_t precision = 53) : Ball(Uninitialised{}, precision) { mpfi_set_d(value_, x); }
  Ball(const Rational& x, mpfr_prec_t precision) : Ball(Uninitialised{}, precision) { mpfi_set_q(value_, x.mpq()); }
  Ball(const Ball& x) : Ball(Uninitialised{}, mpfi_get_prec(x.value_)) { mpfi_set(value_, x.value_); }
  Ball(Ball&& x) noexcept : Ball(Uninitialised{}, MPFR_PREC_MIN) { mpfi_swap(value_, x.value_); }
  Ball& operator=(Ball x) noexcept {
    mpfi_swap(value_, x.value_);
    return *this;
  }
  ~Ball() { mpfi_clear(value_); }

  friend Ball operator+(const Ball& a, const Ball& b) { return combine(mpfi_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return combine(mpfi_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return combine(mpfi_mul, a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return combine(mpfi_div, a, b); }
  friend Ball sqrt(const Ball& a) {
    Ball result(Uninitialised{}, mpfi_get_prec(a.value_));
    mpfi_sqrt(result.value_, a.value_);
    return result;
  }
  /// Enclosures of the smaller, the greater of two numbers, and of either.
  friend Ball min(const Ball& a, const Ball& b) { return endpoints(mpfr_min, mpfr_min, a, b); }
  friend Ball max(const Ball& a, const Ball& b) { return endpoints(mpfr_max, mpfr_max, a, b); }
  friend Ball hull(const Ball& a, const Ball& b) { return endpoints(mpfr_min, mpfr_max, a, b); }

  /// -1 or 1 where the enclosure lies on one side of zero, 0 where it is zero itself; nothing where it does not tell.
  std::optional<int> sign() const;

  /// The double nearest to the number, where all of the enclosure rounds to it; zero is +0.
  std::optional<double> rounded() const;

  /// The double nearest to the middle of the enclosure, 0 where it holds 0. No claim of correct rounding.
  double middle() const;

 private:
  struct Uninitialised {};
  Ball(Uninitialised, mpfr_prec_t precision) { mpfi_init2(value_, precision); }

  template <class Operation>
  static Ball combine(Operation operation, const Ball& a, const Ball& b) {
    Ball result(Uninitialised{}, std::max(mpfi_get_prec(a.value_), mpfi_get_prec(b.value_)));
    operation(result.value_, a.value_, b.value_);
    return result;
  }
  template <class Lower, class Upper>
  static Ball endpoints(Lower lower, Upper upper, const Ball& a, const Ball& b) {
    Ball result(Uninitialised{}, std::max(mpfi_get_prec(a.value_), mpfi_get_prec(b.value_)));
    lower(&result.value_->left, &a.value_->left, &b.value_->left, MPFR_RNDD);
    upper(&result.value_->right, &a.value_->right, &b.value_->right, MPFR_RNDU);
    return result;
  }

  mpfi_t value_;
};

template <>
struct Field<Ball> {
  mpfr_prec_t precision;
  Ball operator()(double x) const { return Ball(x, precision); }
  Ball operator()(const Rational& x) const { return Ball(x, precision); }
};

/// The double nearest to a rational number (ties to even), whatever its size; zero is +0.
double nearest_double(const Rational& x);

}  // namespace pcm::reference
