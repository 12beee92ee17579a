// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bodies/closed_forms.h"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace pcm::compare::closed_forms {
namespace {

template <class Integrand>
long double integral(const Integrand& integrand, long double low, long double high) {
  return boost::math::quadrature::gauss<long double, 30>::integrate(integrand, low, high);
}

long double squared(long double x) {
  return x * x;
}

/// Penetration at the angle t from the ball's, and from the hollow's deepest point, along the master's own normal.
long double depth_of_ball(long double r, long double R, long double d, long double t) {
  return r + d * std::cos(t) - std::sqrt(R * R - squared(d * std::sin(t)));
}
long double depth_of_hollow(long double r, long double R, long double d, long double t) {
  return d * std::cos(t) + std::sqrt(r * r - squared(d * std::sin(t))) - R;
}

}  // namespace

long double sphere_on_plane_sphere_master(long double r, long double h) {
  return kPi * r * h * h;
}

long double sphere_on_plane_plane_master(long double r, long double h) {
  return kPi * h * h * (r - h / 3);
}

long double cylinder_on_plane_cylinder_master(long double r, long double h) {
  const long double t = std::acos(1 - h / r);
  return 2 * r * (r * std::sin(t) - (r - h) * t);
}

long double cylinder_on_plane_plane_master(long double r, long double h) {
  const long double t = std::acos(1 - h / r);
  return r * r * t - (r - h) * std::sqrt(2 * r * h - h * h);
}

long double ball_contact_angle(long double r, long double R, long double d) {
  return std::acos((R * R - r * r - d * d) / (2 * r * d));
}

long double hollow_contact_angle(long double r, long double R, long double d) {
  return std::acos((R * R - r * r + d * d) / (2 * R * d));
}

long double sphere_in_socket_sphere_master(long double r, long double R, long double d) {
  const auto pressure = [=](long double t) { return depth_of_ball(r, R, d, t) * std::cos(t) * std::sin(t); };
  return 2 * kPi * r * r * integral(pressure, 0, ball_contact_angle(r, R, d));
}

long double sphere_in_socket_socket_master(long double r, long double R, long double d) {
  const auto pressure = [=](long double t) { return depth_of_hollow(r, R, d, t) * std::cos(t) * std::sin(t); };
  return 2 * kPi * R * R * integral(pressure, 0, hollow_contact_angle(r, R, d));
}

long double journal_in_bore_journal_master(long double r, long double R, long double d) {
  const auto pressure = [=](long double t) { return depth_of_ball(r, R, d, t) * std::cos(t); };
  return 2 * r * integral(pressure, 0, ball_contact_angle(r, R, d));
}

long double journal_in_bore_bore_master(long double r, long double R, long double d) {
  const auto pressure = [=](long double t) { return depth_of_hollow(r, R, d, t) * std::cos(t); };
  return 2 * R * integral(pressure, 0, hollow_contact_angle(r, R, d));
}

long double sphere_on_sphere(long double r, long double R, long double a) {
  const auto pressure = [=](long double t) {
    return (r - a * std::cos(t) + std::sqrt(R * R - squared(a * std::sin(t)))) * std::cos(t) * std::sin(t);
  };
  return 2 * kPi * r * r * integral(pressure, 0, std::acos((a * a + r * r - R * R) / (2 * a * r)));
}

WedgeForce wedge_on_plane_wedge_master(long double degrees, long double h) {
  const long double p = degrees * kPi / 180;
  const long double z = h * h / 2 * (1 / std::sin(p) + 1 / std::cos(p));
  return {z * std::tan(p - kPi / 4), z};
}

WedgeForce wedge_on_plane_plane_master(long double degrees, long double h) {
  const long double p = degrees * kPi / 180;
  return {0, h * h / 2 * (std::tan(p) + 1 / std::tan(p))};
}

long double hertz_equal_at(long double r, long double equal_at, long double h) {
  return kPi * r * equal_at * equal_at * std::pow(h / equal_at, 1.5L);
}

}  // namespace pcm::compare::closed_forms
