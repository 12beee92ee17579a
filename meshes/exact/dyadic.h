// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace pcm {

/// An exact number m * 2^e, closed under + - *: what a predicate is evaluated with where rounding could decide it.
///
/// Sign and magnitude; the magnitude is an integer in 64-bit limbs times 2^(64 exponent), so sums need no shifts.
/// Limbs live in the object (no heap); only those in use are ever read, written or copied, and zero limbs at both ends
/// are stripped, so that polynomials of ordinary coordinates take 2 to 8 limbs, some tens of nanoseconds an operation.
///
/// Every polynomial up to degree `kDegree` in finite doubles of any size, denormals included, fits; beyond that is a
/// bug (assertion).
class Dyadic {
 public:
  using Limb = std::uint64_t;
  static constexpr int kDegree = 7;

  Dyadic() : sign_(0), size_(0), exponent_(0) {}
  /// Exact; asserts that `x` is finite.
  explicit Dyadic(double x);
  Dyadic(const Dyadic& other) { copy(other); }
  Dyadic& operator=(const Dyadic& other) {
    if (this != &other) copy(other);
    return *this;
  }
  ~Dyadic() = default;

  /// -1, 0 or +1.
  int sign() const { return sign_; }
  /// The number of limbs in use.
  int size() const { return size_; }
  /// The magnitude is less than 2^(64 top()), and no less than 2^(64 (top() - 1)) but for 0.
  int top() const { return exponent_ + size_; }
  /// 2^(64 k) times the value, to a few units in the last place; infinite or zero out of double's range.
  double approximate(int k = 0) const;

  Dyadic operator-() const;
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) { return sum(a, b, b.sign_); }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return sum(a, b, -b.sign_); }
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  /// The sign of a - b.
  friend int sign_of_difference(const Dyadic& a, const Dyadic& b);

 private:
  // A finite double is an integer multiple of 2^-1074 below 2^1024: it lies in the limbs of weight 2^(64 k), k = -17 to
  // 15. A difference of two may carry into one more limb, so a product of seven such takes at most 7 (33 + 1) limbs
  // before stripping. It is below 2^(7 * 1025) = 2^7175 and the last of its limbs ends at 2^(64 * 113) = 2^7232, so
  // that a sum of up to 2^57 of them takes no further limb; one is held in reserve, as a sum writes its last carry.
  static constexpr int kLimbsOfDouble = 33;
  static constexpr int kCapacity = kDegree * (kLimbsOfDouble + 1) + 1;
  static_assert(64 * -17 <= -1074 && 64 * (kLimbsOfDouble - 17) >= 1024, "every double lies in its limbs");
  static_assert(64 * kDegree * (kLimbsOfDouble - 17) + 64 >= kDegree * 1025 + 57, "room for sums of products");

  Limb limb(int k) const { return k < exponent_ || k >= top() ? 0 : limbs_[static_cast<std::size_t>(k - exponent_)]; }
  void copy(const Dyadic& other);
  void strip();
  static int compare_magnitudes(const Dyadic& a, const Dyadic& b);
  static Dyadic sum(const Dyadic& a, const Dyadic& b, int sign_of_b);

  int sign_;
  int size_;
  int exponent_;                       // of the lowest limb in use, counted in limbs
  std::array<Limb, kCapacity> limbs_;  // the lowest first; those from size_ on are never read
};

}  // namespace pcm
