// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/ball.h"

namespace pcm::reference {

std::optional<int> Ball::sign() const {
  if (mpfi_is_zero(value_)) return 0;
  if (mpfi_is_strictly_pos(value_)) return 1;
  if (mpfi_is_strictly_neg(value_)) return -1;
  return {};
}

std::optional<double> Ball::rounded() const {
  // Adding +0 turns -0 into +0.
  const double lower = mpfr_get_d(&value_->left, MPFR_RNDN) + 0.0;
  const double upper = mpfr_get_d(&value_->right, MPFR_RNDN) + 0.0;
  if (lower == upper) return lower;
  return {};
}

double Ball::middle() const {
  if (mpfi_has_zero(value_)) return 0;
  return mpfi_get_d(value_) + 0.0;
}

double nearest_double(const Rational& x) {
  // Rounded twice only where both ends agree, or where the binary expansion ends within the precision.
  for (mpfr_prec_t precision = 128;; precision *= 2)
    if (const std::optional<double> value = Ball(x, precision).rounded()) return *value;
}

}  // namespace pcm::reference
