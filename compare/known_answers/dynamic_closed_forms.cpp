// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/dynamic_closed_forms.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace pcm::compare {

namespace {

/// Root of a function that is negative at `low` and positive at `high`, by bisection down to neighbouring doubles.
template <typename Function>
double root_between(double low, double high, const Function& function) {
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high)) return middle;
    (function(middle) < 0 ? low : high) = middle;
  }
}

}  // namespace

double flat_restitution(double z, DampingMode mode) {
  const double w = std::sqrt(1 - z * z);
  switch (mode) {
    case DampingMode::full:
      return std::exp(-std::numbers::pi * z / w);
    case DampingMode::no_tension:
      return std::exp(-z / w * (std::numbers::pi - std::atan2(2 * z * w, 1 - 2 * z * z)));
    case DampingMode::compression:
      return std::exp(-z / w * std::atan(w / z));
  }
  return 0;
}

double faded_restitution(double a) {
  const double left = a - std::log1p(a);
  const double greatest = std::min(1.0, 1 / a);
  return root_between(0, greatest, [&](double e) { return -a * e - std::log1p(-a * e) - left; });
}

Drop quadratic_drop(double k, const Dropped& body) {
  const double m = body.mass, g = body.gravity, energy = m * body.speed * body.speed / 2;
  // Beyond this depth the work exceeds both terms together.
  const double beyond = std::cbrt(6 * energy / k) + std::sqrt(6 * m * g / k);
  Drop drop;
  drop.depth =
      root_between(std::sqrt(m * g / k), beyond, [&](double h) { return k * h * h * h / 3 - m * g * h - energy; });
  drop.force = k * drop.depth * drop.depth;
  // v^2 = (h_max - h) (c (h^2 + h h_max + h_max^2) - 2 g), c = 2 k / (3 m); h = h_max (1 - s^2) takes the root away.
  const double h_max = drop.depth, c = 2 * k / (3 * m);
  drop.contact_time = 2 * boost::math::quadrature::gauss<double, 30>::integrate(
                              [&](double s) {
                                const double h = h_max * (1 - s * s);
                                const double rest = c * (h * h + h * h_max + h_max * h_max) - 2 * g;
                                return 2 * std::sqrt(h_max / rest);
                              },
                              0.0, 1.0);
  return drop;
}

Drop polyhedral_drop(const PolyhedralFoundation& foundation, double plane_at_zero, double plane_end,
                     const Dropped& body) {
  const double m = body.mass, g = body.gravity, v0 = body.speed;
  const auto missing_energy = [&](double plane) {
    return foundation.work(plane) - m * g * (plane - plane_at_zero) - m * v0 * v0 / 2;
  };
  const double start = g > 0 ? polyhedral_rest(foundation, plane_at_zero, plane_end, m * g) : plane_at_zero;
  const double deepest = root_between(start, plane_end, missing_energy);
  Drop drop;
  drop.depth = deepest - plane_at_zero;
  drop.force = foundation.force(deepest);
  // plane = deepest - depth s^2 as above; the integrand is analytic between the kinks.
  std::vector<double> ends{0, 1};
  for (const double kink : foundation.kinks()) {
    if (plane_at_zero < kink && kink < deepest) ends.push_back(std::sqrt((deepest - kink) / drop.depth));
  }
  std::sort(ends.begin(), ends.end());
  const auto pace = [&](double s) {
    const double squared_speed = -2 / m * missing_energy(deepest - drop.depth * s * s);
    return 2 * drop.depth * s / std::sqrt(squared_speed);
  };
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i] < ends[i + 1]) {
      drop.contact_time += 2 * boost::math::quadrature::gauss<double, 10>::integrate(pace, ends[i], ends[i + 1]);
    }
  }
  return drop;
}

double polyhedral_rest(const PolyhedralFoundation& foundation, double plane_at_zero, double plane_end, double force) {
  return root_between(plane_at_zero, plane_end, [&](double plane) { return foundation.force(plane) - force; });
}

double creep_speed(double slope, double friction) {
  return 1 - std::sqrt(1 - slope / friction);
}

double stopping_distance(double speed, double friction, double slip_velocity, double gravity) {
  const double deceleration = friction * gravity;
  return speed * speed / (2 * deceleration) + slip_velocity * slip_velocity / deceleration * (std::numbers::ln2 - 0.5);
}

}  // namespace pcm::compare
