// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "reference/clipped_elements.h"

namespace pcm::reference {
namespace {

/// A point of the master's plane and the slave face's depth d there.
template <class T>
struct Sample {
  T s, t, d;
};

template <class T>
std::vector<Sample<T>> corners_of(LiftedPose<T>& pose, const MasterFrame<T>& e, Face master, const Vec3<T>& depth,
                                  const PieceOutline& outline) {
  std::vector<Vec3<T>> lines;
  lines.reserve(outline.size());
  for (const SightLine& line : outline) lines.push_back(coefficients(pose, e, master, line));
  std::vector<Sample<T>> corners;
  corners.reserve(outline.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Vec3<T> corner = cross(lines[i], lines[i + 1 == lines.size() ? 0 : i + 1]);
    const T s = corner.x / corner.z, t = corner.y / corner.z;
    corners.push_back({s, t, depth.x * s + depth.y * t + depth.z});
  }
  return corners;
}

/// Twice the area of a polygon in (s, t), six times the integral of d over it and 24 times those of s d and t d.
template <class T>
struct Moments {
  T area2, d6, sd24, td24;

  /// Over a triangle of area A whose corners are x_i with depths d_i, for linear d, the integral of d is A/3 sum d_i,
  /// that of x d is A/12 (sum x_i d_i + sum x_i sum d_i).
  void add(const Sample<T>& a, const Sample<T>& b, const Sample<T>& c) {
    const T A2 = (b.s - a.s) * (c.t - a.t) - (b.t - a.t) * (c.s - a.s);
    const T d = a.d + b.d + c.d;
    area2 = area2 + A2;
    d6 = d6 + A2 * d;
    sd24 = sd24 + A2 * (a.s * (a.d + d) + b.s * (b.d + d) + c.s * (c.d + d));
    td24 = td24 + A2 * (a.t * (a.d + d) + b.t * (b.d + d) + c.t * (c.d + d));
  }
};

template <class T>
ElementGeometry<T> geometry_of(LiftedPose<T>& pose, const ClippedElement& element) {
  using std::max;
  const Face master{element.faces.master, element.faces.master_face};
  const Face slave{other(master.side), element.faces.slave_face};
  const MasterFrame<T> e = make_frame(pose, master);
  const Depth<T> fraction = depth_of(pose, e, slave);
  const Vec3<T> depth = T(pose.number(1.0) / fraction.denominator) * fraction.numerator;

  const T zero = pose.number(0.0);
  Moments<T> sum{zero, zero, zero, zero};
  T greatest = zero;
  for (const PieceOutline& outline : element.pieces) {
    const std::vector<Sample<T>> x = corners_of(pose, e, master, depth, outline);
    for (const Sample<T>& corner : x) greatest = max(greatest, corner.d);
    for (std::size_t i = 2; i < x.size(); ++i) sum.add(x[0], x[i - 1], x[i]);
  }
  const T d24 = pose.number(4.0) * sum.d6;
  return {e.N,
          fraction.N_g,
          sum.area2 / pose.number(2.0),
          sum.d6 / (pose.number(3.0) * sum.area2),
          greatest,
          e.p0 + T(sum.sd24 / d24) * e.v1 + T(sum.td24 / d24) * e.v2};
}

}  // namespace

ElementGeometry<DoubleDouble> ClippedElements::geometry(std::size_t i, LiftedPose<DoubleDouble>& pose) const {
  return geometry_of(pose, elements_[i]);
}

ElementGeometry<Ball> ClippedElements::geometry(std::size_t i, LiftedPose<Ball>& pose) const {
  return geometry_of(pose, elements_[i]);
}

ElementGeometry<Rational> ClippedElements::geometry(std::size_t i, LiftedPose<Rational>& pose) const {
  return geometry_of(pose, elements_[i]);
}

}  // namespace pcm::reference
