// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/exact/exact_signs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "meshes/base/floating_point_policy.h"
#include "meshes/exact/dyadic.h"

namespace pcm {
namespace {

constexpr double kRoundoff = std::numeric_limits<double>::epsilon() / 2;
constexpr double kLeastDenormal = std::numeric_limits<double>::denorm_min();

/// The sign of `value` where `bound` on its error leaves no doubt, else 0. Not-a-number from overflow leaves doubt.
int certain_sign(double value, double bound) {
  if (value > bound && std::isfinite(value)) return 1;
  if (value < -bound && std::isfinite(value)) return -1;
  return 0;
}

/// Zero where it is in doubt. A rounded difference is off by u of its size, its product with another by 3 u to first
/// order; the last subtraction adds u of the result. Products that underflow are off by half the least denormal each.
int filtered_turn_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y());
  const double right = (b.y() - a.y()) * (c.x() - a.x());
  const double bound = 5 * kRoundoff * (std::abs(left) + std::abs(right)) + 4 * kLeastDenormal;
  return certain_sign(left - right, bound);
}

int exact_turn_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Dyadic ax(a.x());
  const Dyadic ay(a.y());
  return sign_of_difference((Dyadic(b.x()) - ax) * (Dyadic(c.y()) - ay), (Dyadic(b.y()) - ay) * (Dyadic(c.x()) - ax));
}

/// (a x b) . c of rounded differences, and what its error is measured by.
struct TripleProduct {
  double value = 0;
  double size = 0;      ///< the sum of its six products' magnitudes
  double greatest = 0;  ///< magnitude among the coordinates of c

  /// Between these limits what underflow loses of a partial product, 2^-1075, doesn't count beside the error bound.
  bool is_in_range() const { return size > 0x1p-500 && greatest < 0x1p400; }
};

/// Each of the six products of three rounded differences is off by 5 u of its size to first order and passes through
/// four additions: an error below 10 u of `size`.
TripleProduct triple_product(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d minors(std::abs(a.y() * b.z()) + std::abs(a.z() * b.y()),
                               std::abs(a.z() * b.x()) + std::abs(a.x() * b.z()),
                               std::abs(a.x() * b.y()) + std::abs(a.y() * b.x()));
  return {a.cross(b).dot(c), minors.dot(c.cwiseAbs()), c.cwiseAbs().maxCoeff()};
}

int exact_side_sign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    const Eigen::Vector3d& p) {
  const auto difference = [&a](const Eigen::Vector3d& q, int k) { return Dyadic(q[k]) - Dyadic(a[k]); };
  Dyadic volume;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    const int j = (k + 2) % 3;
    volume = volume + (difference(b, i) * difference(c, j) - difference(b, j) * difference(c, i)) * difference(p, k);
  }
  return volume.sign();
}

}  // namespace

int turn_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const int sign = filtered_turn_sign(a, b, c);
  return sign != 0 ? sign : exact_turn_sign(a, b, c);
}

int area_sign(std::span<const Eigen::Vector2d> polygon) {
  // Twice the area is the sum of a x b over the edges, all taken from the first point. Each product is off by 3 u of
  // its size to first order and passes through at most n + 1 additions.
  const std::size_t n = polygon.size();
  double area = 0;
  double size = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Eigen::Vector2d a = polygon[i] - polygon[0];
    const Eigen::Vector2d b = polygon[i + 1] - polygon[0];
    area += a.x() * b.y() - a.y() * b.x();
    size += std::abs(a.x() * b.y()) + std::abs(a.y() * b.x());
  }
  const auto terms = static_cast<double>(n);
  const int sign = certain_sign(area, 2 * (terms + 4) * kRoundoff * size + 4 * terms * kLeastDenormal);
  if (sign != 0) return sign;
  Dyadic exact;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[i + 1 < n ? i + 1 : 0];
    exact = exact + Dyadic(a.x()) * Dyadic(b.y()) - Dyadic(a.y()) * Dyadic(b.x());
  }
  return exact.sign();
}

int side_sign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& p) {
  const TripleProduct volume = triple_product(b - a, c - a, p - a);
  if (volume.is_in_range()) {
    const int sign = certain_sign(volume.value, 12 * kRoundoff * volume.size);
    if (sign != 0) return sign;
  }
  return exact_side_sign(a, b, c, p);
}

bool are_collinear(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  // Cheap certainty first: one component of the normal that is surely not zero is enough.
  for (int axis = 0; axis < 3; ++axis)
    if (filtered_turn_sign(without_axis(a, axis), without_axis(b, axis), without_axis(c, axis)) != 0) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (exact_turn_sign(without_axis(a, axis), without_axis(b, axis), without_axis(c, axis)) != 0) return false;
  return true;
}

int volume_sign(const std::vector<Eigen::Vector3d>& vertices, std::span<const Triangle> faces) {
  if (faces.empty()) return 0;
  // Six times the volume is the sum of a . (b x c) over the faces, seen from any point: here from a vertex.
  const Eigen::Vector3d& origin = vertices[faces[0][0]];
  TripleProduct volume;
  for (const Triangle& face : faces) {
    const TripleProduct term =
        triple_product(vertices[face[0]] - origin, vertices[face[1]] - origin, vertices[face[2]] - origin);
    volume.value += term.value;
    volume.size += term.size;
    volume.greatest = std::max(volume.greatest, term.greatest);
  }
  if (volume.is_in_range()) {
    const double additions = static_cast<double>(faces.size());
    const int sign = certain_sign(volume.value, 2 * (additions + 12) * kRoundoff * volume.size);
    if (sign != 0) return sign;
  }
  Dyadic exact;
  for (const Triangle& face : faces) {
    const auto coordinate = [&](std::size_t corner, int k) { return Dyadic(vertices[face[corner]][k]); };
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3;
      const int j = (k + 2) % 3;
      exact = exact + coordinate(0, k) * (coordinate(1, i) * coordinate(2, j) - coordinate(1, j) * coordinate(2, i));
    }
  }
  return exact.sign();
}

}  // namespace pcm
