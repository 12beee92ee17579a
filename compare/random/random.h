// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Random123/philox.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

/// Random numbers of the verification poses: the same bits on every machine, compiler and thread (DESIGN section 4).
namespace pcm::compare {

/// The rotation of the quaternion w + x i + y j + z k of any length but 0, in a fixed order of operations; orthogonal
/// to a few 1e-16.
inline Eigen::Matrix3d ordered_rotation(double w, double x, double y, double z) {
  // Dividing by the squared length once spares the normalisation, and with it two roundings.
  const double s = 2 / (w * w + x * x + y * y + z * z);
  Eigen::Matrix3d A;
  A << 1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),  //
      s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x),   //
      s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y);
  return A;
}

/// What random numbers of a pose are for: each purpose has a stream of its own, so that drawing more for one changes
/// nothing in the others.
enum class Purpose : std::uint64_t { pose, law, velocity };

/// The random numbers of one pose: a pure function of (seed, stratum, pair, pose, purpose), by the counter-based
/// generator Philox4x64 (Salmon et al. 2011). No state outlives the pose. Only + - * / sqrt and exact scalings turn
/// bits into numbers, each correctly rounded, in a fixed order of operations.
class PoseRandom {
 public:
  PoseRandom(std::uint64_t seed, std::uint64_t stratum, std::uint64_t pair, std::uint64_t pose,
             Purpose purpose = Purpose::pose)
      : key_{{seed, stratum}}, counter_{{pair, pose, 0, static_cast<std::uint64_t>(purpose)}} {}

  /// 64 uniform bits.
  std::uint64_t bits() {
    if (used_ == 4) {
      block_ = r123::Philox4x64()(counter_, key_);
      ++counter_[2];
      used_ = 0;
    }
    return block_[used_++];
  }

  /// Uniform integer in [0, n), n >= 1. Rejection makes it exactly uniform.
  std::uint64_t below(std::uint64_t n) {
    const std::uint64_t whole = UINT64_MAX - UINT64_MAX % n;
    std::uint64_t drawn = bits();
    while (drawn >= whole) drawn = bits();
    return drawn % n;
  }

  bool coin() { return (bits() >> 63) != 0; }

  /// Uniform multiple of 2^-53 in [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// In [low, high], 0 < low <= high: a uniform integer binary exponent, then a uniform mantissa, by rejection.
  double log_uniform(double low, double high) {
    const int first = std::ilogb(low);
    const int exponents = std::ilogb(high) - first + 1;
    for (;;) {
      const int exponent = first + static_cast<int>(below(static_cast<std::uint64_t>(exponents)));
      const double value = std::ldexp(1 + uniform(), exponent);
      if (value >= low && value <= high) return value;
    }
  }

  /// Uniform direction of length 1 to rounding, by rejection from the ball.
  Eigen::Vector3d direction() {
    for (;;) {
      const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
      const double square = x * x + y * y + z * z;
      if (square > 1 || square < 0x1p-20) continue;
      const double length = std::sqrt(square);
      return {x / length, y / length, z / length};
    }
  }

  /// Uniform rotation, by a quaternion drawn from the 4-ball by rejection.
  Eigen::Matrix3d rotation() {
    for (;;) {
      const double w = uniform(-1, 1), x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
      const double square = w * w + x * x + y * y + z * z;
      if (square > 1 || square < 0x1p-20) continue;
      return ordered_rotation(w, x, y, z);
    }
  }

 private:
  r123::Philox4x64::key_type key_;
  r123::Philox4x64::ctr_type counter_;
  r123::Philox4x64::ctr_type block_{};
  std::size_t used_ = 4;
};

/// Dot product in a fixed order of operations: Eigen's may differ with the vector instructions of the machine.
inline double ordered_dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// A x in the order of operations of the rounded problem (PCM section 1).
inline Eigen::Vector3d ordered_product(const Eigen::Matrix3d& A, const Eigen::Vector3d& x) {
  return {A(0, 0) * x.x() + A(0, 1) * x.y() + A(0, 2) * x.z(), A(1, 0) * x.x() + A(1, 1) * x.y() + A(1, 2) * x.z(),
          A(2, 0) * x.x() + A(2, 1) * x.y() + A(2, 2) * x.z()};
}

/// Cross product in a fixed order of operations.
inline Eigen::Vector3d ordered_cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}

/// The vector scaled to length 1, however long or short it is; it must not be null, nor infinite.
inline Eigen::Vector3d ordered_normalized(const Eigen::Vector3d& a) {
  const int exponent = std::ilogb(a.cwiseAbs().maxCoeff());
  const Eigen::Vector3d scaled(std::scalbn(a.x(), -exponent), std::scalbn(a.y(), -exponent),
                               std::scalbn(a.z(), -exponent));
  const double length = std::sqrt(ordered_dot(scaled, scaled));
  return {scaled.x() / length, scaled.y() / length, scaled.z() / length};
}

}  // namespace pcm::compare
