// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "reference/pose/converted_pose.h"

/// The lines that bound what a master face e = (p0, p1, p2) sees along its normal (PCM section 6, clipped scheme), by
/// name and in numbers of any kind. A point of its plane is x = p0 + s (p1 - p0) + t (p2 - p0), a line a s + b t + c =
/// 0 is kept as the vector (a, b, c). No division: coefficients are polynomials of the vertices' coordinates.
namespace pcm::reference {

/// A face of either surface.
struct Face {
  Side side = Side::E;
  Index index = 0;
  auto operator<=>(const Face&) const = default;
};

/// A line by what it is the trace of. The same name always has the same coefficients, sign included.
struct VisibilityLine {
  enum class Kind : std::uint8_t {
    edge,  ///< the projection of the edge from vertex a to vertex b, a < b
    fold,  ///< where the faces a and b have the same depth; b may be e itself, whose depth is 0
  };
  Kind kind = Kind::edge;
  Side side_a = Side::E;
  Index a = 0;
  Side side_b = Side::E;
  Index b = 0;
  auto operator<=>(const VisibilityLine&) const = default;
};

/// The master face e and its doubled normal N, in numbers of kind T.
template <class T>
struct MasterFrame {
  Vec3<T> p0, v1, v2;  ///< v_i = p_i - p0
  Vec3<T> N, N_x_v1, N_x_v2;
};

template <class T>
MasterFrame<T> make_frame(ConvertedPose<T>& pose, Face master) {
  const auto p = pose.corners(master.side, master.index);
  MasterFrame<T> e{p[0], p[1] - p[0], p[2] - p[0], pose.zero(), pose.zero(), pose.zero()};
  e.N = cross(e.v1, e.v2);
  e.N_x_v1 = cross(e.N, e.v1);
  e.N_x_v2 = cross(e.N, e.v2);
  return e;
}

/// D(x) = N . ((a - x) x (b - x)), linear in x: positive on the left of the projected edge from a to b, seen against N.
template <class T>
Vec3<T> projected_edge(const MasterFrame<T>& e, const Vec3<T>& a, const Vec3<T>& b) {
  const Vec3<T> from = a - e.p0, along = b - a;
  const T zero = from.x - from.x;
  return {zero - dot(e.N_x_v1, along), zero - dot(e.N_x_v2, along), dot(e.N, cross(from, along))};
}

/// The depth d_g(x) = ((x - g0) . N_g) / (N . N_g) at which the line x - d N meets the plane of g, as a fraction.
template <class T>
struct Depth {
  Vec3<T> numerator;  ///< linear in (s, t, 1)
  T denominator;      ///< its sign tells how g faces e: -1 where the line leaves g's body
  Vec3<T> N_g;
};

template <class T>
Depth<T> depth_of(ConvertedPose<T>& pose, const MasterFrame<T>& e, Face g) {
  const auto p = pose.corners(g.side, g.index);
  const Vec3<T> N_g = doubled_normal(p[0], p[1], p[2]);
  return {{dot(e.v1, N_g), dot(e.v2, N_g), dot(e.p0 - p[0], N_g)}, dot(e.N, N_g), N_g};
}

/// d_a - d_b times the product of their denominators; for b = e, the numerator of d_a.
template <class T>
Vec3<T> fold(ConvertedPose<T>& pose, const MasterFrame<T>& e, Face master, Face a, Face b) {
  const Depth<T> d_a = depth_of(pose, e, a);
  if (b == master) return d_a.numerator;
  const Depth<T> d_b = depth_of(pose, e, b);
  return d_b.denominator * d_a.numerator - d_a.denominator * d_b.numerator;
}

/// The coefficients (a, b, c).
template <class T>
Vec3<T> coefficients(ConvertedPose<T>& pose, const MasterFrame<T>& e, Face master, const VisibilityLine& line) {
  if (line.kind == VisibilityLine::Kind::edge)
    return projected_edge(e, pose.point({line.side_a, line.a}), pose.point({line.side_b, line.b}));
  return fold(pose, e, master, {line.side_a, line.a}, {line.side_b, line.b});
}

}  // namespace pcm::reference
