// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/bodies/polyhedral_foundation.h"
#include "pcm/inputs.h"

/// What the dynamic known answers should be: closed forms, solved or integrated numerically where they are implicit.
namespace pcm::compare {

/// Restitution of a vertical bounce with flat contact, damping ratio 0 < z < 1: u'' + 2 z w u' + w^2 u = 0 from u = 0
/// up to u = 0 (full), up to where u'' = 0 (no tension); damped only while approaching (compression).
double flat_restitution(double z, DampingMode mode);

/// The same with damping that fades as u / u_d: the root e of a - ln(1 + a) = -a e - ln(1 - a e), a > 0.
double faded_restitution(double a);

/// A mass m dropped on a spring of the work W(h): h_max where W = m v0^2 / 2 + m g h, and the time of h > 0.
struct Drop {
  double depth = 0;         ///< h_max, m
  double contact_time = 0;  ///< s
  double force = 0;         ///< at h_max, N
};

/// What is dropped: mass kg, speed m/s where h = 0, gravity m/s^2.
struct Dropped {
  double mass = 1;
  double speed = 1;
  double gravity = 0;
};

/// W = k h^3 / 3, F = k h^2: the sphere as master has k = pi K r.
Drop quadratic_drop(double k, const Dropped& body);

/// W of a polyhedron, h = plane - plane_at_zero; h_max is sought up to `plane_end`.
Drop polyhedral_drop(const PolyhedralFoundation& foundation, double plane_at_zero, double plane_end,
                     const Dropped& body);

/// The height of the plane where the polyhedron's force is `force`, between `plane_at_zero` and `plane_end`.
double polyhedral_rest(const PolyhedralFoundation& foundation, double plane_at_zero, double plane_end, double force);

/// Creep on an incline of the slope tan a < mu, in units of v_eps: mu s (2 - s) = tan a.
double creep_speed(double slope, double friction);

/// Distance in which friction stops a body of speed v0 >= v_eps: mu g above v_eps, mu g s (2 - s) below, s = v / v_eps.
double stopping_distance(double speed, double friction, double slip_velocity, double gravity);

}  // namespace pcm::compare
