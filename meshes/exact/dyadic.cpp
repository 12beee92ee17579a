// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/exact/dyadic.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace pcm {

namespace {

__extension__ typedef unsigned __int128 Wide;

}  // namespace

Dyadic::Dyadic(double x) {
  assert(std::isfinite(x));
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>((bits >> 52) & 0x7ff);
  const Limb fraction = bits & ((Limb{1} << 52) - 1);
  // |x| = mantissa * 2^power; denormals (biased == 0) share the exponent of the smallest normal numbers.
  const Limb mantissa = biased == 0 ? fraction : fraction | (Limb{1} << 52);
  const int power = std::max(biased, 1) - 1075;
  const int shift = power & 63;
  exponent_ = (power - shift) / 64;
  sign_ = (bits >> 63) != 0 ? -1 : 1;
  size_ = 2;
  limbs_[0] = mantissa << shift;
  limbs_[1] = shift == 0 ? 0 : mantissa >> (64 - shift);
  strip();
}

void Dyadic::copy(const Dyadic& other) {
  sign_ = other.sign_;
  size_ = other.size_;
  exponent_ = other.exponent_;
  std::copy_n(other.limbs_.begin(), size_, limbs_.begin());
}

void Dyadic::strip() {
  while (size_ > 0 && limbs_[static_cast<std::size_t>(size_ - 1)] == 0) --size_;
  if (size_ == 0) {
    sign_ = exponent_ = 0;
    return;
  }
  int zeros = 0;
  while (limbs_[static_cast<std::size_t>(zeros)] == 0) ++zeros;
  if (zeros > 0) {
    std::copy(limbs_.begin() + zeros, limbs_.begin() + size_, limbs_.begin());
    size_ -= zeros;
    exponent_ += zeros;
  }
}

double Dyadic::approximate(int k) const {
  double result = 0;
  for (int i = top() - 1; i >= std::max(exponent_, top() - 3); --i) {
    result += std::ldexp(static_cast<double>(limb(i)), 64 * (i + k));
  }
  return sign_ * result;
}

Dyadic Dyadic::operator-() const {
  Dyadic result(*this);
  result.sign_ = -sign_;
  return result;
}

int Dyadic::compare_magnitudes(const Dyadic& a, const Dyadic& b) {
  // Stripped magnitudes start with a non-zero limb, so the one that reaches higher is the greater.
  if (a.size_ == 0 || b.size_ == 0) return (a.size_ > 0) - (b.size_ > 0);
  if (a.top() != b.top()) return a.top() > b.top() ? 1 : -1;
  for (int k = a.top() - 1; k >= std::min(a.exponent_, b.exponent_); --k) {
    if (a.limb(k) != b.limb(k)) return a.limb(k) > b.limb(k) ? 1 : -1;
  }
  return 0;
}

int sign_of_difference(const Dyadic& a, const Dyadic& b) {
  if (a.sign_ != b.sign_) return a.sign_ > b.sign_ ? 1 : -1;
  return a.sign_ * Dyadic::compare_magnitudes(a, b);
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, int sign_of_b) {
  if (sign_of_b == 0) return a;
  if (a.sign_ == 0) {
    Dyadic result(b);
    result.sign_ = sign_of_b;
    return result;
  }
  const bool add = a.sign_ == sign_of_b;
  const int order = add ? 1 : compare_magnitudes(a, b);
  Dyadic result;
  if (order == 0) return result;
  const Dyadic& greater = order > 0 ? a : b;
  const Dyadic& smaller = order > 0 ? b : a;
  result.sign_ = order > 0 ? a.sign_ : sign_of_b;
  result.exponent_ = std::min(a.exponent_, b.exponent_);
  const int top = std::max(a.top(), b.top());
  assert(top - result.exponent_ < kCapacity);
  Limb carry = 0;
  for (int k = result.exponent_; k < top; ++k) {
    // Modulo 2^128 a borrow leaves ones in the upper half, a carry a one.
    const Wide limb =
        add ? Wide{greater.limb(k)} + smaller.limb(k) + carry : Wide{greater.limb(k)} - smaller.limb(k) - carry;
    result.limbs_[static_cast<std::size_t>(result.size_++)] = static_cast<Limb>(limb);
    carry = static_cast<Limb>(limb >> 64) & 1;
  }
  if (carry != 0) result.limbs_[static_cast<std::size_t>(result.size_++)] = carry;
  result.strip();
  return result;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  Dyadic result;
  if (a.sign_ == 0 || b.sign_ == 0) return result;
  result.sign_ = a.sign_ * b.sign_;
  result.exponent_ = a.exponent_ + b.exponent_;
  result.size_ = a.size_ + b.size_;
  assert(result.size_ <= Dyadic::kCapacity);
  Dyadic::Limb* const product = result.limbs_.data();
  std::fill_n(product, result.size_, Dyadic::Limb{0});
  for (int i = 0; i < a.size_; ++i) {
    const Wide factor = a.limbs_[static_cast<std::size_t>(i)];
    Dyadic::Limb carry = 0;
    for (int j = 0; j < b.size_; ++j) {
      const Wide limb = factor * b.limbs_[static_cast<std::size_t>(j)] + product[i + j] + carry;
      product[i + j] = static_cast<Dyadic::Limb>(limb);
      carry = static_cast<Dyadic::Limb>(limb >> 64);
    }
    product[i + b.size_] = carry;
  }
  result.strip();
  return result;
}

}  // namespace pcm
