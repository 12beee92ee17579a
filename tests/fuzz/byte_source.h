// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace pcm::fuzz {

/// Reads choices and numbers from bytes; zeros where there are none left. Most numbers are small multiples of 1/8, so
/// that features of two surfaces coincide more often than not.
class ByteSource {
 public:
  explicit ByteSource(std::string_view bytes) : bytes_(bytes) {}

  bool empty() const { return bytes_.empty(); }

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const auto first = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return first;
  }

  /// In [0, n), 1 <= n <= 256.
  int below(int n) { return byte() % n; }

  /// A multiple of 1/8 between -4 and 4 in three draws of four, some ulps away from one in half of the rest, else any
  /// finite double whose |value| is 0 or between 2^-40 and 2^40.
  double number() {
    const int kind = below(8);
    if (kind == 7) return any_double();
    double value = small_number();
    if (kind == 6) {
      const int ulps = below(17) - 8;
      const double towards =
          ulps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
      for (int i = 0; i < std::abs(ulps); ++i) value = std::nextafter(value, towards);
      if (std::abs(value) < kLeast) value = 0;
    }
    return value;
  }

  /// Positive, 2^-40 to 2^40, in most draws a power of two.
  double positive() {
    const int exponent = below(81) - 40;
    return std::ldexp(below(4) == 3 ? 1 + below(256) / 256.0 : 1, exponent);
  }

  Eigen::Vector3d vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  static constexpr double kLeast = 0x1p-40, kGreatest = 0x1p40;

  double small_number() { return (below(65) - 32) / 8.0; }

  double any_double() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    const bool fits = std::abs(value) >= kLeast && std::abs(value) <= kGreatest;  // false of what is no number
    return fits ? value : 0;
  }

  std::string_view bytes_;
};

}  // namespace pcm::fuzz
