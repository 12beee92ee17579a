// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>

/// Rational arithmetic and hard doubles that the predicates' tests are made of.
namespace pcm::fast {

using RationalVector = std::array<mpq_class, 3>;

inline RationalVector rational(const Eigen::Vector3d& x) {
  return {mpq_class(x[0]), mpq_class(x[1]), mpq_class(x[2])};
}

inline RationalVector minus(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline mpq_class dot(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline RationalVector cross(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Draws doubles of the kinds that break predicates.
class Doubles {
 public:
  explicit Doubles(std::uint64_t seed) : random_(seed) {
    std::printf("  seed %llu\n", static_cast<unsigned long long>(seed));
  }

  std::int64_t integer(std::int64_t least, std::int64_t greatest) {
    return std::uniform_int_distribution<std::int64_t>(least, greatest)(random_);
  }
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  /// Any finite double, denormals included: every bit pattern is as likely as any other.
  double any() {
    double x = 0;
    do x = std::bit_cast<double>(random_());
    while (!std::isfinite(x));
    return x;
  }
  /// A double of binary exponent up to `exponent` either way; negative zeros among them.
  double scaled(int exponent) {
    if (integer(0, 15) == 0) return integer(0, 1) == 0 ? 0.0 : -0.0;
    return std::ldexp(unit(), static_cast<int>(integer(-exponent, exponent)));
  }
  double denormal() { return std::ldexp(static_cast<double>(integer(-9, 9)), -1074); }
  /// The ends of double's range, and one.
  double extreme() {
    constexpr std::array<double, 4> kMagnitudes{0, std::numeric_limits<double>::denorm_min(), 1,
                                                std::numeric_limits<double>::max()};
    return (integer(0, 1) == 0 ? -1 : 1) * kMagnitudes[static_cast<std::size_t>(integer(0, 3))];
  }
  double small_integer(std::int64_t greatest) { return static_cast<double>(integer(-greatest, greatest)); }
  /// Moves x by up to `ulps` units in the last place.
  double nudged(double x, int ulps) {
    for (auto n = integer(-ulps, ulps); n != 0; n -= n > 0 ? 1 : -1) x = std::nextafter(x, n > 0 ? 1e300 : -1e300);
    return x;
  }

  template <class Draw>
  static Eigen::Vector3d point(Draw&& draw) {
    const double x = draw(), y = draw(), z = draw();
    return {x, y, z};
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace pcm::fast
