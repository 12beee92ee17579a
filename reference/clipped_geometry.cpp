// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "reference/clipped_elements.h"

namespace pcm::reference {
namespace {

/// A point of the master's plane.
template <class T>
struct PlanePoint {
  T s, t;
};

/// Corner i is where side i ends and side i + 1 begins.
template <class T>
std::vector<PlanePoint<T>> corners_of(LiftedPose<T>& pose, const MasterFrame<T>& e, Face master,
                                      const PieceOutline& outline) {
  std::vector<Vec3<T>> lines;
  lines.reserve(outline.size());
  for (const SightLine& line : outline) lines.push_back(coefficients(pose, e, master, line));
  std::vector<PlanePoint<T>> corners;
  corners.reserve(outline.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Vec3<T> corner = cross(lines[i], lines[i + 1 == lines.size() ? 0 : i + 1]);
    corners.push_back({corner.x / corner.z, corner.y / corner.z});
  }
  return corners;
}

/// A point of the master's plane and the slave face's depth d there.
template <class T>
struct Sample {
  T s, t, d;
};

template <class T>
std::vector<Sample<T>> with_depth(const std::vector<PlanePoint<T>>& corners, const Vec3<T>& depth) {
  std::vector<Sample<T>> samples;
  samples.reserve(corners.size());
  for (const auto& [s, t] : corners) samples.push_back({s, t, depth.x * s + depth.y * t + depth.z});
  return samples;
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
    const std::vector<Sample<T>> x = with_depth(corners_of(pose, e, master, outline), depth);
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

/// A side of a convex piece.
template <class T>
struct PieceSide {
  SightLine line;
  std::size_t piece;
  PlanePoint<T> from, to;
};

template <class T>
std::vector<PieceSide<T>> sides_of(LiftedPose<T>& pose, const MasterFrame<T>& e, const ClippedElement& element) {
  const Face master{element.faces.master, element.faces.master_face};
  std::vector<PieceSide<T>> sides;
  for (std::size_t piece = 0; piece < element.pieces.size(); ++piece) {
    const PieceOutline& outline = element.pieces[piece];
    const std::vector<PlanePoint<T>> corners = corners_of(pose, e, master, outline);
    for (std::size_t i = 0; i < outline.size(); ++i)
      sides.push_back({outline[i], piece, corners[i == 0 ? outline.size() - 1 : i - 1], corners[i]});
  }
  return sides;
}

/// Which part of side a is also of side b, on the same line in the opposite direction; 0 for one in the same.
template <class T>
T common_fraction(LiftedPose<T>& pose, const PieceSide<T>& a, const PieceSide<T>& b) {
  using std::max, std::min;
  const T s = a.to.s - a.from.s, t = a.to.t - a.from.t, square = s * s + t * t;
  const auto along = [&](const PlanePoint<T>& x) -> T {
    return ((x.s - a.from.s) * s + (x.t - a.from.t) * t) / square;
  };
  const T zero = pose.number(0.0), one = pose.number(1.0);
  return max(zero, T(min(one, along(b.from)) - max(zero, along(b.to))));
}

/// Where the part was cut, the pieces on either side have sides on the line of the cut. No two pieces have common area,
/// so what two sides on one line have in common lies within the part, and a third has no more than an end there.
template <class T>
T perimeter_of(LiftedPose<T>& pose, const ClippedElement& element) {
  const MasterFrame<T> e = make_frame(pose, {element.faces.master, element.faces.master_face});
  const std::vector<PieceSide<T>> sides = sides_of(pose, e, element);
  T sum = pose.number(0.0);
  for (const PieceSide<T>& a : sides) {
    T outer = pose.number(1.0);
    for (const PieceSide<T>& b : sides)
      if (a.piece != b.piece && a.line == b.line) outer = outer - common_fraction(pose, a, b);
    const Vec3<T> along = T(a.to.s - a.from.s) * e.v1 + T(a.to.t - a.from.t) * e.v2;
    sum = sum + outer * sqrt(dot(along, along));
  }
  return sum;
}

/// The gradient g of a difference of depths, (d_a - d_b) |N|, in the master's plane: g . v1 and g . v2 are |N| times
/// its coefficients, so |N| g = b (N x v1) - a (N x v2). A height over a face is its cosine times a depth.
template <class T>
T folds_of(LiftedPose<T>& pose, const ClippedElement& element) {
  using std::min;
  const Face master{element.faces.master, element.faces.master_face};
  const MasterFrame<T> e = make_frame(pose, master);
  T sum = pose.number(0.0);
  for (const PieceSide<T>& side : sides_of(pose, e, element)) {
    const Face a{side.line.side_a, side.line.a}, b{side.line.side_b, side.line.b};
    if (side.line.kind != SightLine::Kind::fold || a == master || b == master) continue;
    const Depth<T> d_a = depth_of(pose, e, a), d_b = depth_of(pose, e, b);
    const T slope_s = d_a.numerator.x / d_a.denominator - d_b.numerator.x / d_b.denominator;
    const T slope_t = d_a.numerator.y / d_a.denominator - d_b.numerator.y / d_b.denominator;
    const Vec3<T> gradient_N = slope_t * e.N_x_v1 - slope_s * e.N_x_v2;
    const Vec3<T> along = T(side.to.s - side.from.s) * e.v1 + T(side.to.t - side.from.t) * e.v2;
    const auto square_cosine = [&](const Depth<T>& d) -> T {
      return d.denominator * d.denominator / (dot(e.N, e.N) * dot(d.N_g, d.N_g));
    };
    const T least = min(square_cosine(d_a), square_cosine(d_b));
    sum = sum + sqrt(dot(along, along) * dot(e.N, e.N) / (dot(gradient_N, gradient_N) * least));
  }
  return sum;
}

}  // namespace

DoubleDouble ClippedElements::folds(std::size_t i, LiftedPose<DoubleDouble>& pose) const {
  return folds_of(pose, elements_[i]);
}

Ball ClippedElements::folds(std::size_t i, LiftedPose<Ball>& pose) const {
  return folds_of(pose, elements_[i]);
}

DoubleDouble ClippedElements::perimeter(std::size_t i, LiftedPose<DoubleDouble>& pose) const {
  return perimeter_of(pose, elements_[i]);
}

Ball ClippedElements::perimeter(std::size_t i, LiftedPose<Ball>& pose) const {
  return perimeter_of(pose, elements_[i]);
}

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
