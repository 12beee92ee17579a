// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/prism/exact_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcm::fast {

namespace {

/// A power of two such that scaling everything by 2^k scales what is made of exact numbers in that unit exactly, too:
/// their limbs have 64 bits. `size` is a length of the face.
double unit_for(double size) {
  const int exponent = std::ilogb(size) % 64;
  return std::ldexp(1, exponent < 0 ? -exponent : 64 - exponent);
}

/// x - p0 times the unit, which p0 is multiplied by already.
NumberVector<Dyadic> from_p0(const Eigen::Vector3d& p0, double unit, const Eigen::Vector3d& x) {
  const Eigen::Vector3d to = unit * x;
  return difference<Dyadic>(to.data(), p0.data());
}

NumberVector<Dyadic> normal_of(const std::array<Eigen::Vector3d, 3>& p, double unit) {
  const Eigen::Vector3d p0 = unit * p[0];
  return cross(from_p0(p0, unit, p[1]), from_p0(p0, unit, p[2]));
}

}  // namespace

ExactPlane::ExactPlane(const std::array<Eigen::Vector3d, 3>& p)
    : unit_(unit_for((p[1] - p[0]).cwiseAbs().maxCoeff())), p0_(unit_ * p[0]), N_(normal_of(p, unit_)) {}

Dyadic ExactPlane::exact_height(const Eigen::Vector3d& x) const {
  return dot(N_, from_p0(p0_, unit_, x));
}

double ExactPlane::height(const Eigen::Vector3d& x) const {
  const Dyadic height = exact_height(x);
  if (height.sign() == 0) return 0;
  // Times the cube of the unit it may be beyond what a double holds.
  const int top = height.top();
  return keeping_sign(std::ldexp(height.approximate(-top), 64 * top - 3 * std::ilogb(unit_)), height.sign());
}

ScaledHeights ExactPlane::heights(const std::array<Eigen::Vector3d, 3>& x) const {
  const std::array<Dyadic, 3> exact{exact_height(x[0]), exact_height(x[1]), exact_height(x[2])};
  int top = std::numeric_limits<int>::min();
  for (const Dyadic& height : exact) {
    if (height.sign() != 0) top = std::max(top, height.top());
  }
  ScaledHeights scaled;
  if (top == std::numeric_limits<int>::min()) return scaled;
  for (std::size_t k = 0; k < 3; ++k) scaled.value[k] = exact[k].approximate(-top);
  scaled.exponent = 64 * top - 3 * std::ilogb(unit_);
  return scaled;
}

Eigen::Vector3d exact_normal(const std::array<Eigen::Vector3d, 3>& p, double size) {
  const double unit = unit_for(size);
  const NumberVector<Dyadic> N = normal_of(p, unit);
  return Eigen::Vector3d(N.x.approximate(), N.y.approximate(), N.z.approximate()) / (unit * unit);
}

}  // namespace pcm::fast
