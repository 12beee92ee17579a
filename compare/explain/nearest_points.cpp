// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/explain/nearest_points.h"

#include <limits>
#include <utility>

#include "reference/numbers/ball.h"

namespace pcm::compare {
namespace {

using reference::cross;
using reference::determinant;
using reference::dot;
using reference::doubled_normal;
using reference::Exact;
using reference::Rational;
using reference::sign_of;

double quotient(const Exact& numerator, const Exact& denominator) {
  return reference::nearest_double(Rational(numerator) / Rational(denominator));
}

bool is_zero(const ExactPoint& x) {
  return sign_of(x.x) == 0 && sign_of(x.y) == 0 && sign_of(x.z) == 0;
}

/// Where the lines a + s u and c + t v are nearest to each other: s and t times n^2, n = u x v not 0, by
/// (c - a) = s u - t v + h n.
struct LineFeet {
  ExactPoint n;
  Exact s, t, squared, height;  ///< n^2 and h n^2

  LineFeet(const ExactPoint& a, const ExactPoint& u, const ExactPoint& c, const ExactPoint& v)
      : n(cross(u, v)), squared(dot(n, n)) {
    const ExactPoint w = c - a;
    s = determinant(w, v, n);
    t = determinant(w, u, n);
    height = dot(w, n);
  }
  bool parallel() const { return sign_of(squared) == 0; }

  /// |h n|^2 = (h n^2)^2 / n^2.
  NearestPoints nearest() const {
    const int side = sign_of(height);
    return {height * height, squared, side < 0 ? Exact(-1) * n : n, s, squared};
  }
};

bool is_inside_unit(const Exact& part, const Exact& whole) {
  return sign_of(part) > 0 && sign_of(whole - part) > 0;
}

}  // namespace

bool NearestPoints::within(const Exact& width) const {
  return sign_of(width * width * squared_denominator - squared_numerator) >= 0;
}

double NearestPoints::distance() const {
  if (sign_of(squared_numerator) == 0) return 0;
  const Rational squared = Rational(squared_numerator) / Rational(squared_denominator);
  // A root of a rational number that is halfway between two doubles has 54 bits: its enclosures are exact.
  constexpr mpfr_prec_t kFirst = 64, kLast = 4096;
  const double distance = reference::rounded_number(
      kFirst, kLast, [&](mpfr_prec_t precision) { return sqrt(reference::Ball(squared, precision)); });
  return distance > 0 ? distance : std::numeric_limits<double>::denorm_min();
}

Eigen::Vector3d NearestPoints::unit_apart() const {
  int greatest = 0;
  const auto magnitude = [&](int i) { return sign_of(apart[i]) < 0 ? Exact(0) - apart[i] : apart[i]; };
  for (int i = 1; i < 3; ++i)
    if (sign_of(magnitude(i) - magnitude(greatest)) > 0) greatest = i;
  const Exact scale = magnitude(greatest);
  if (sign_of(scale) == 0) return Eigen::Vector3d::Zero();
  return Eigen::Vector3d(quotient(apart.x, scale), quotient(apart.y, scale), quotient(apart.z, scale)).normalized();
}

double NearestPoints::place() const {
  return quotient(place_numerator, place_denominator);
}

NearestPoints nearest_points(const ExactPoint& x, const ExactPoint& y) {
  const ExactPoint d = y - x;
  return {dot(d, d), 1, d};
}

std::optional<NearestPoints> nearest_points(const ExactPoint& x, const ExactSegment& edge) {
  const ExactPoint u = edge[1] - edge[0], w = x - edge[0];
  const Exact whole = dot(u, u);
  if (!is_inside_unit(dot(u, w), whole)) return std::nullopt;
  // The way from x to its foot is -(u x w) x u / u^2.
  const ExactPoint normal = cross(u, w);
  return NearestPoints{dot(normal, normal), whole, cross(u, normal)};
}

std::optional<NearestPoints> nearest_points(const ExactPoint& x, const ExactTriangle& face) {
  const ExactPoint N = doubled_normal(face[0], face[1], face[2]);
  for (std::size_t i = 0; i < 3; ++i)
    if (sign_of(determinant(N, face[i] - x, face[(i + 1) % 3] - x)) <= 0) return std::nullopt;
  const Exact height = dot(N, x - face[0]);
  return NearestPoints{height * height, dot(N, N), sign_of(height) > 0 ? Exact(-1) * N : N};
}

std::optional<NearestPoints> nearest_points(const ExactSegment& first, const ExactSegment& second) {
  const LineFeet feet(first[0], first[1] - first[0], second[0], second[1] - second[0]);
  if (feet.parallel() || !is_inside_unit(feet.s, feet.squared) || !is_inside_unit(feet.t, feet.squared))
    return std::nullopt;
  return feet.nearest();
}

std::optional<NearestPoints> nearest_points(const ExactRay& ray, const ExactPoint& x) {
  const ExactPoint& u = ray.direction;
  const ExactPoint w = x - ray.origin;
  const Exact along = dot(u, w), whole = dot(u, u);
  if (is_zero(u) || sign_of(along) < 0) return std::nullopt;
  const ExactPoint normal = cross(u, w);
  return NearestPoints{dot(normal, normal), whole, cross(normal, u), along, whole};
}

std::optional<NearestPoints> nearest_points(const ExactRay& ray, const ExactSegment& edge) {
  const LineFeet feet(ray.origin, ray.direction, edge[0], edge[1] - edge[0]);
  if (feet.parallel() || sign_of(feet.s) < 0 || !is_inside_unit(feet.t, feet.squared)) return std::nullopt;
  return feet.nearest();
}

}  // namespace pcm::compare
