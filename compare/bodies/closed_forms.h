// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Forces of the elastic foundation between smooth bodies, without friction: areal stiffness 1 N/m^3, lengths in
/// metres, forces in newtons (per metre of length for cylinders). Accurate to a few ulps of long double, where the
/// arguments lie in the ranges given; nothing is checked.
namespace pcm::compare::closed_forms {

inline constexpr long double kPi = 3.14159265358979323846264338327950288L;

/// Sphere of radius r pressed into a plane by h, 0 < h <= r: pi r h^2 with the sphere as master, and the volume of the
/// cap pi h^2 (r - h / 3) with the plane as master.
long double sphere_on_plane_sphere_master(long double r, long double h);
long double sphere_on_plane_plane_master(long double r, long double h);

/// Cylinder of radius r pressed into a plane by h, 0 < h <= r, per length: 2 r (r sin t - (r - h) t) with the cylinder
/// as master, cos t = 1 - h / r, and the area of the segment with the plane as master.
long double cylinder_on_plane_cylinder_master(long double r, long double h);
long double cylinder_on_plane_plane_master(long double r, long double h);

/// Angle t at which the contact of a ball of radius r ends, seen from its own centre, when it is displaced by d in a
/// hollow of radius R, 0 <= R - r < d; the hollow's is the one seen from the centre of the hollow.
long double ball_contact_angle(long double r, long double R, long double d);
long double hollow_contact_angle(long double r, long double R, long double d);

/// Sphere of radius r displaced by d in a spherical hollow of radius R: the integral over the master's surface of the
/// penetration u(t) times cos t, by Gauss-Legendre quadrature (u is analytic up to the contact's edge).
/// Ball master: u = r + d cos t - sqrt(R^2 - d^2 sin^2 t); hollow master: u = d cos t + sqrt(r^2 - d^2 sin^2 t) - R.
long double sphere_in_socket_sphere_master(long double r, long double R, long double d);
long double sphere_in_socket_socket_master(long double r, long double R, long double d);

/// The same for a cylinder in a bore, per length.
long double journal_in_bore_journal_master(long double r, long double R, long double d);
long double journal_in_bore_bore_master(long double r, long double R, long double d);

/// Sphere of radius r, the master, pressed into one of radius R, their centres a apart, sqrt(r^2 + R^2) < a < r + R:
/// the same integral of u = r - a cos t + sqrt(R^2 - a^2 sin^2 t).
long double sphere_on_sphere(long double r, long double R, long double a);

/// Wedge of two perpendicular faces, pressed into a plane by h edge first, per width; one face is tilted by p degrees
/// from the plane, x is the inward horizontal of that face, z the plane's normal.
/// Wedge master: z = (h^2 / 2) (1 / sin p + 1 / cos p), x = z tan(p - 45 deg); plane master: z = (h^2 / 2) (tan p +
/// cot p), x = 0.
struct WedgeForce {
  long double x = 0;
  long double z = 0;
};
WedgeForce wedge_on_plane_wedge_master(long double degrees, long double h);
WedgeForce wedge_on_plane_plane_master(long double degrees, long double h);

/// Hertz (1882), sphere on half-space: (4/3) E* sqrt(r) h^1.5, with E* such that it equals the elastic foundation's
/// force (sphere master) at the depth `equal_at`: equal_at = (4 E* / (3 pi K))^2 / r.
long double hertz_equal_at(long double r, long double equal_at, long double h);

}  // namespace pcm::compare::closed_forms
