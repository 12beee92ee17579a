// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "reference/ball.h"
#include "reference/clipped_elements.h"

namespace pcm::reference {
namespace {

/// A point of the master's plane and f's depth there.
template <class T>
struct Sample {
  T s, t, d;
};

template <class T>
std::vector<Sample<T>> corners_of(LiftedPose<T>& pose, const MasterFrame<T>& e, Face master, const Depth<T>& depth,
                                  const PieceOutline& outline) {
  std::vector<Vec3<T>> lines;
  for (const SightLine& line : outline) lines.push_back(coefficients(pose, e, master, line));
  std::vector<Sample<T>> corners;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Vec3<T> corner = cross(lines[i], lines[i + 1 == lines.size() ? 0 : i + 1]);
    corners.push_back(
        {corner.x / corner.z, corner.y / corner.z, dot(depth.numerator, corner) / (depth.denominator * corner.z)});
  }
  return corners;
}

}  // namespace

template <class T>
ElementGeometry<T> geometry_of(LiftedPose<T>& pose, const ClippedElement& element) {
  using std::max;
  const Face master{element.faces.master, element.faces.master_face};
  const Face slave{other(master.side), element.faces.slave_face};
  const MasterFrame<T> e = make_frame(pose, master);
  const Depth<T> depth = depth_of(pose, e, slave);
  const auto f = pose.corners(slave.side, slave.index);

  // Over a triangle of area A, corners x_i, depths d_i: integral of d = A/3 sum d_i, of x d = A/12 (sum x_i d_i +
  // sum x_i sum d_j), both exact for linear d.
  const T two = pose.number(2.0), three = pose.number(3.0), twelve = pose.number(12.0);
  T area = pose.number(0.0), volume = area, moment_s = area, moment_t = area, greatest = area;
  for (const PieceOutline& outline : element.pieces) {
    const std::vector<Sample<T>> x = corners_of(pose, e, master, depth, outline);
    for (const Sample<T>& corner : x) greatest = max(greatest, corner.d);
    for (std::size_t i = 2; i < x.size(); ++i) {
      const Sample<T>&a = x[0], &b = x[i - 1], &c = x[i];
      const T A = ((b.s - a.s) * (c.t - a.t) - (b.t - a.t) * (c.s - a.s)) / two;
      const T d = a.d + b.d + c.d;
      area = area + A;
      volume = volume + A * d / three;
      moment_s = moment_s + A * (a.s * a.d + b.s * b.d + c.s * c.d + (a.s + b.s + c.s) * d) / twelve;
      moment_t = moment_t + A * (a.t * a.d + b.t * b.d + c.t * c.d + (a.t + b.t + c.t) * d) / twelve;
    }
  }
  return {e.N,      doubled_normal(f[0], f[1], f[2]),
          area,     volume / area,
          greatest, e.p0 + T(moment_s / volume) * e.v1 + T(moment_t / volume) * e.v2};
}

template ElementGeometry<Rational> geometry_of(LiftedPose<Rational>&, const ClippedElement&);
template ElementGeometry<Ball> geometry_of(LiftedPose<Ball>&, const ClippedElement&);

}  // namespace pcm::reference
