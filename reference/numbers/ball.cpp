// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/numbers/ball.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace pcm::reference {
namespace {

void multiply(mpfr_t product, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t rounding) {
  if (mpfr_zero_p(x) || mpfr_zero_p(y))
    mpfr_set_zero(product, 1);
  else
    mpfr_mul(product, x, y, rounding);
}

}  // namespace

void Ball::make_room(mpfr_prec_t precision) {
  const std::size_t limbs = mpfr_custom_get_size(precision) / sizeof(mp_limb_t);
  mp_limb_t* room = inline_limbs_.data();
  if (limbs > kInlineLimbs) {
    heap_limbs_ = std::make_unique<mp_limb_t[]>(2 * limbs);
    room = heap_limbs_.get();
  }
  mpfr_custom_init(room, precision);
  mpfr_custom_init(room + limbs, precision);
  mpfr_custom_init_set(lower_, MPFR_ZERO_KIND, 0, precision, room);
  mpfr_custom_init_set(upper_, MPFR_ZERO_KIND, 0, precision, room + limbs);
}

Ball::Ball(mpfr_prec_t precision) {
  make_room(precision);
}

Ball::Ball(const Ball& a, const Ball& b) : Ball(std::max(mpfr_get_prec(a.lower_), mpfr_get_prec(b.lower_))) {}

void Ball::set_whole_line() {
  mpfr_set_inf(lower_, -1);
  mpfr_set_inf(upper_, 1);
}

Ball::Ball(double x, mpfr_prec_t precision) : Ball(precision) {
  if (!std::isfinite(x)) {
    set_whole_line();
    return;
  }
  mpfr_set_d(lower_, x, MPFR_RNDD);
  mpfr_set_d(upper_, x, MPFR_RNDU);
}

Ball::Ball(const Rational& x, mpfr_prec_t precision) : Ball(precision) {
  mpfr_set_q(lower_, x.mpq(), MPFR_RNDD);
  mpfr_set_q(upper_, x.mpq(), MPFR_RNDU);
}

Ball::Ball(const Ball& x) : Ball(mpfr_get_prec(x.lower_)) {
  mpfr_set(lower_, x.lower_, MPFR_RNDD);
  mpfr_set(upper_, x.upper_, MPFR_RNDU);
}

Ball& Ball::operator=(const Ball& x) {
  if (this == &x) return *this;
  if (mpfr_get_prec(lower_) != mpfr_get_prec(x.lower_)) make_room(mpfr_get_prec(x.lower_));
  mpfr_set(lower_, x.lower_, MPFR_RNDD);
  mpfr_set(upper_, x.upper_, MPFR_RNDU);
  return *this;
}

Ball operator+(const Ball& a, const Ball& b) {
  Ball sum(a, b);
  mpfr_add(sum.lower_, a.lower_, b.lower_, MPFR_RNDD);
  mpfr_add(sum.upper_, a.upper_, b.upper_, MPFR_RNDU);
  return sum;
}

Ball operator-(const Ball& a, const Ball& b) {
  Ball difference(a, b);
  mpfr_sub(difference.lower_, a.lower_, b.upper_, MPFR_RNDD);
  mpfr_sub(difference.upper_, a.upper_, b.lower_, MPFR_RNDU);
  return difference;
}

Ball operator*(const Ball& a, const Ball& b) {
  Ball product(a, b);
  const auto ends = [&product](mpfr_srcptr l1, mpfr_srcptr l2, mpfr_srcptr u1, mpfr_srcptr u2) {
    multiply(product.lower_, l1, l2, MPFR_RNDD);
    multiply(product.upper_, u1, u2, MPFR_RNDU);
  };
  if (a.not_negative() && b.not_negative()) {
    ends(a.lower_, b.lower_, a.upper_, b.upper_);
  } else if (a.not_negative() && b.not_positive()) {
    ends(a.upper_, b.lower_, a.lower_, b.upper_);
  } else if (a.not_positive() && b.not_negative()) {
    ends(a.lower_, b.upper_, a.upper_, b.lower_);
  } else if (a.not_positive() && b.not_positive()) {
    ends(a.upper_, b.upper_, a.lower_, b.lower_);
  } else {
    // One holds zero within: the extremes are among all four products.
    ends(a.lower_, b.lower_, a.lower_, b.lower_);
    Ball candidate(a, b);
    for (const auto& [x, y] : std::initializer_list<std::pair<mpfr_srcptr, mpfr_srcptr>>{
             {a.lower_, b.upper_}, {a.upper_, b.lower_}, {a.upper_, b.upper_}}) {
      multiply(candidate.lower_, x, y, MPFR_RNDD);
      multiply(candidate.upper_, x, y, MPFR_RNDU);
      mpfr_min(product.lower_, product.lower_, candidate.lower_, MPFR_RNDD);
      mpfr_max(product.upper_, product.upper_, candidate.upper_, MPFR_RNDU);
    }
  }
  return product;
}

Ball operator/(const Ball& a, const Ball& b) {
  Ball quotient(a, b);
  const bool positive = mpfr_sgn(b.lower_) > 0, negative = mpfr_sgn(b.upper_) < 0;
  if (!positive && !negative) {
    quotient.set_whole_line();
    return quotient;
  }
  // Of the end of a that makes the quotient least, and of that which makes it greatest, the quotient moves the same way
  // with b whatever the sign of b. The end of b that an infinite end of a is divided by is the one nearer to zero,
  // which is finite.
  const mpfr_srcptr least = positive ? a.lower_ : a.upper_, greatest = positive ? a.upper_ : a.lower_;
  mpfr_div(quotient.lower_, least, mpfr_sgn(least) >= 0 ? b.upper_ : b.lower_, MPFR_RNDD);
  mpfr_div(quotient.upper_, greatest, mpfr_sgn(greatest) >= 0 ? b.lower_ : b.upper_, MPFR_RNDU);
  return quotient;
}

Ball sqrt(const Ball& a) {
  assert(mpfr_sgn(a.upper_) >= 0);
  Ball root(a, a);
  if (mpfr_sgn(a.lower_) > 0) mpfr_sqrt(root.lower_, a.lower_, MPFR_RNDD);
  mpfr_sqrt(root.upper_, a.upper_, MPFR_RNDU);
  return root;
}

Ball min(const Ball& a, const Ball& b) {
  Ball result(a, b);
  mpfr_min(result.lower_, a.lower_, b.lower_, MPFR_RNDD);
  mpfr_min(result.upper_, a.upper_, b.upper_, MPFR_RNDU);
  return result;
}

Ball max(const Ball& a, const Ball& b) {
  Ball result(a, b);
  mpfr_max(result.lower_, a.lower_, b.lower_, MPFR_RNDD);
  mpfr_max(result.upper_, a.upper_, b.upper_, MPFR_RNDU);
  return result;
}

Ball hull(const Ball& a, const Ball& b) {
  Ball result(a, b);
  mpfr_min(result.lower_, a.lower_, b.lower_, MPFR_RNDD);
  mpfr_max(result.upper_, a.upper_, b.upper_, MPFR_RNDU);
  return result;
}

Ball where_negative(const Ball& x, const Ball& a, const Ball& b) {
  const std::optional<int> sign = x.sign();
  if (!sign) return hull(a, b);
  return *sign < 0 ? a : b;
}

std::optional<int> Ball::sign() const {
  if (mpfr_zero_p(lower_) && mpfr_zero_p(upper_)) return 0;
  if (mpfr_sgn(lower_) > 0) return 1;
  if (mpfr_sgn(upper_) < 0) return -1;
  return {};
}

std::optional<double> Ball::rounded() const {
  if (!is_finite()) return {};
  // Adding +0 turns -0 into +0.
  const double lower = mpfr_get_d(lower_, MPFR_RNDN) + 0.0;
  const double upper = mpfr_get_d(upper_, MPFR_RNDN) + 0.0;
  if (lower == upper) return lower;
  return {};
}

std::optional<double> Ball::nearly_rounded() const {
  if (!is_finite()) return {};
  const double lower = mpfr_get_d(lower_, MPFR_RNDN);
  const double upper = mpfr_get_d(upper_, MPFR_RNDN);
  if (std::nextafter(lower, std::numeric_limits<double>::infinity()) < upper) return {};
  Ball middle(*this, *this);
  mpfr_add(middle.lower_, lower_, upper_, MPFR_RNDN);
  mpfr_div_2ui(middle.lower_, middle.lower_, 1, MPFR_RNDN);
  return mpfr_get_d(middle.lower_, MPFR_RNDN) + 0.0;
}

NearDouble Ball::nearby() const {
  const double infinity = std::numeric_limits<double>::infinity();
  if (!is_finite()) return {0, infinity};
  const double value = mpfr_get_d(lower_, MPFR_RNDN);
  if (!std::isfinite(value)) return {0, infinity};
  Ball distance(*this, *this);
  mpfr_d_sub(distance.lower_, value, lower_, MPFR_RNDU);
  mpfr_sub_d(distance.upper_, upper_, value, MPFR_RNDU);
  return {value, std::max({mpfr_get_d(distance.lower_, MPFR_RNDU), mpfr_get_d(distance.upper_, MPFR_RNDU), 0.0})};
}

double nearest_double(const Rational& x) {
  // Rounded twice only where both ends agree, or where the binary expansion ends within the precision.
  for (mpfr_prec_t precision = 128;; precision *= 2)
    if (const std::optional<double> value = Ball(x, precision).rounded()) return *value;
}

}  // namespace pcm::reference
