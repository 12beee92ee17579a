// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include "reference/elements/clipped_elements.h"

namespace pcm::reference {
namespace {

template <class T>
inline constexpr bool kIsDual = false;
template <class T>
inline constexpr bool kIsDual<Dual<T>> = true;

/// A point of the master's plane.
template <class T>
struct PlanePoint {
  T s, t;
};

/// Corner i is where side i ends and side i + 1 begins.
template <class T>
std::vector<PlanePoint<T>> corners_of(ConvertedPose<T>& pose, const MasterFrame<T>& e, Face master,
                                      const PieceOutline& outline) {
  std::vector<Vec3<T>> lines;
  lines.reserve(outline.size());
  for (const VisibilityLine& line : outline) lines.push_back(coefficients(pose, e, master, line));
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

/// Twice the area of polygons in (s, t), six times the integral of d over them and 24 times those of s d and t d.
template <class T>
struct Moments {
  T area2, d6, sd24, td24;

  /// A convex polygon. Over a triangle of area A whose corners are x_i with depths d_i, for linear d, the integral of d
  /// is A/3 sum d_i, that of x d is A/12 (sum x_i d_i + sum x_i sum d_i).
  void add(const std::vector<Sample<T>>& polygon) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const Sample<T>&a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
      const T A2 = (b.s - a.s) * (c.t - a.t) - (b.t - a.t) * (c.s - a.s);
      const T d = a.d + b.d + c.d;
      area2 = area2 + A2;
      d6 = d6 + A2 * d;
      sd24 = sd24 + A2 * (a.s * (a.d + d) + b.s * (b.d + d) + c.s * (c.d + d));
      td24 = td24 + A2 * (a.t * (a.d + d) + b.t * (b.d + d) + c.t * (c.d + d));
    }
  }
};

/// Adds a convex polygon with min(d, q_max) instead of d, cut in two by the line d = q_max.
///
/// An enclosure may not tell on which side of that line a corner x_i lies. Where no corner surely lies beyond it, or
/// none surely before it, it is near the line, and the polygon need not be cut: min is concave, so at any point of the
/// polygon min(d, q_max) is at least the mean of min(d_i, q_max) with that point's weights, and at most that of d_i and
/// at most q_max; and s and t are not negative. So to enclose both d_i and q_max at such corners encloses the moments.
/// Where there are corners on both sides as well, d_i and min(d_i, q_max) at all of them do, if not tightly.
/// Derivatives are not enclosed by that: of them nothing is known then. Where all corners are surely no deeper than the
/// line and some before it, it has no area in common with the polygon, and d_i is what changes also at corners on it.
template <class T>
void add_clamped(const std::vector<Sample<T>>& polygon, const T& q_max, Moments<T>& sum) {
  std::vector<std::optional<int>> signs;
  const T* in_doubt = nullptr;
  bool any_before = false, any_beyond = false;
  for (const Sample<T>& corner : polygon) {
    signs.push_back(T(corner.d - q_max).sign());
    if (!signs.back()) in_doubt = &corner.d;
    any_before = any_before || signs.back() == -1;
    any_beyond = any_beyond || signs.back() == 1;
  }
  std::vector<Sample<T>> before, beyond;
  if (!any_before || !any_beyond || in_doubt != nullptr) {
    const bool both = any_before && any_beyond;
    if constexpr (kIsDual<T>)
      if (in_doubt != nullptr) {
        const T zero = q_max - q_max;
        sum.d6 = sum.d6 + zero / zero;
      }
    const bool surely_before = in_doubt == nullptr && any_before;
    for (const Sample<T>& x : polygon)
      before.push_back({x.s, x.t,
                        surely_before ? x.d
                        : both        ? where_negative(T(*in_doubt - q_max), x.d, min(x.d, q_max))
                                      : where_negative(T(x.d - q_max), x.d, q_max)});
    sum.add(before);
    return;
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = i + 1 == polygon.size() ? 0 : i + 1;
    const Sample<T>&x = polygon[i], &y = polygon[next];
    if (*signs[i] <= 0) before.push_back(x);
    if (*signs[i] >= 0) beyond.push_back({x.s, x.t, q_max});
    if (*signs[i] * *signs[next] >= 0) continue;
    const T fraction = (q_max - x.d) / (y.d - x.d);
    before.push_back({x.s + fraction * (y.s - x.s), x.t + fraction * (y.t - x.t), q_max});
    beyond.push_back(before.back());
  }
  sum.add(before);
  sum.add(beyond);
}

/// The part of a master face that is an element, in numbers of kind T.
template <class T>
struct SeenPart {
  MasterFrame<T> e;
  Vec3<T> slave_N;
  std::vector<std::vector<Sample<T>>> pieces;
};

template <class T>
SeenPart<T> part_of(ConvertedPose<T>& pose, const ClippedElement& element) {
  const Face master{element.faces.master, element.faces.master_face};
  const Face slave{other(master.side), element.faces.slave_face};
  SeenPart<T> part{make_frame(pose, master), pose.zero(), {}};
  const Depth<T> fraction = depth_of(pose, part.e, slave);
  part.slave_N = fraction.N_g;
  const Vec3<T> depth = T(pose.number(1.0) / fraction.denominator) * fraction.numerator;
  part.pieces.reserve(element.pieces.size());
  for (const PieceOutline& outline : element.pieces)
    part.pieces.push_back(with_depth(corners_of(pose, part.e, master, outline), depth));
  return part;
}

SeenPart<Quadratic> converted(const SeenPart<Rational>& part) {
  const auto& [p0, v1, v2, N, N_x_v1, N_x_v2] = part.e;
  SeenPart<Quadratic> result{
      {converted(p0), converted(v1), converted(v2), converted(N), converted(N_x_v1), converted(N_x_v2)},
      converted(part.slave_N),
      {}};
  for (const std::vector<Sample<Rational>>& piece : part.pieces) {
    std::vector<Sample<Quadratic>>& samples = result.pieces.emplace_back();
    for (const auto& [s, t, d] : piece) samples.push_back({Quadratic(s), Quadratic(t), Quadratic(d)});
  }
  return result;
}

/// Not clamped.
template <class T>
ElementGeometry<T> geometry_of(const SeenPart<T>& part, const Field<T>& field) {
  using std::max;
  const T zero = field(0.0);
  Moments<T> sum{zero, zero, zero, zero};
  T greatest = zero;
  for (const std::vector<Sample<T>>& piece : part.pieces) {
    for (const Sample<T>& corner : piece) greatest = max(greatest, corner.d);
    sum.add(piece);
  }
  const T d24 = field(4.0) * sum.d6;
  return {part.e.N,
          part.slave_N,
          sum.area2 / field(2.0),
          sum.d6 / (field(3.0) * sum.area2),
          greatest,
          part.e.p0 + T(sum.sd24 / d24) * part.e.v1 + T(sum.td24 / d24) * part.e.v2};
}

/// The same with q and foot clamped; `g` is not.
template <class T>
ElementGeometry<T> clamped_geometry_of(const SeenPart<T>& part, ElementGeometry<T> g, const T& q_max,
                                       const Field<T>& field) {
  const T zero = field(0.0);
  Moments<T> sum{zero, zero, zero, zero};
  for (const std::vector<Sample<T>>& piece : part.pieces) add_clamped(piece, q_max, sum);
  const T d24 = field(4.0) * sum.d6;
  g.q = sum.d6 / (field(6.0) * g.alpha);
  g.foot = part.e.p0 + T(sum.sd24 / d24) * part.e.v1 + T(sum.td24 / d24) * part.e.v2;
  return g;
}

template <class T>
ElementGeometry<T> enclosed_geometry(ConvertedPose<T>& pose, const ClippedElement& element, double max_penetration) {
  const SeenPart<T> part = part_of(pose, element);
  const ElementGeometry<T> g = geometry_of(part, pose.field());
  if (std::isinf(max_penetration)) return g;
  const T q_max = pose.number(max_penetration) / sqrt(dot(g.N, g.N));
  if (T(g.q_greatest - q_max).sign() == -1) return g;
  return clamped_geometry_of(part, g, q_max, pose.field());
}

/// A side of a convex piece.
template <class T>
struct PieceSide {
  VisibilityLine line;
  std::size_t piece;
  PlanePoint<T> from, to;
};

template <class T>
std::vector<PieceSide<T>> sides_of(ConvertedPose<T>& pose, const MasterFrame<T>& e, const ClippedElement& element) {
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

/// A length or a sum of lengths: each a number times the root of another.
template <class T>
struct RootTerm {
  T factor, square;
};

template <class T>
T enclosed_sum(const std::vector<RootTerm<T>>& terms, const Field<T>& field) {
  T sum = field(0.0);
  for (const auto& [factor, square] : terms) sum = sum + factor * sqrt(square);
  return sum;
}

RadicalSum radical_sum(const std::vector<RootTerm<Rational>>& terms) {
  RadicalSum sum;
  for (const auto& [factor, square] : terms) sum.add(factor, square);
  return sum;
}

/// A side between two corners in one place; an enclosure may not tell.
template <class T>
bool surely_no_length(const PieceSide<T>& side) {
  if constexpr (std::same_as<T, Rational>) return side.from.s == side.to.s && side.from.t == side.to.t;
  return false;
}

/// Which part of side a is also of side b, on the same line in the opposite direction; 0 for one in the same.
template <class T>
T common_fraction(ConvertedPose<T>& pose, const PieceSide<T>& a, const PieceSide<T>& b) {
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
std::vector<RootTerm<T>> perimeter_of(ConvertedPose<T>& pose, const ClippedElement& element) {
  const MasterFrame<T> e = make_frame(pose, {element.faces.master, element.faces.master_face});
  const std::vector<PieceSide<T>> sides = sides_of(pose, e, element);
  std::vector<RootTerm<T>> terms;
  for (const PieceSide<T>& a : sides) {
    if (surely_no_length(a)) continue;
    T outer = pose.number(1.0);
    for (const PieceSide<T>& b : sides)
      if (a.piece != b.piece && a.line == b.line) outer = outer - common_fraction(pose, a, b);
    const Vec3<T> along = T(a.to.s - a.from.s) * e.v1 + T(a.to.t - a.from.t) * e.v2;
    terms.push_back({outer, dot(along, along)});
  }
  return terms;
}

}  // namespace

DoubleDouble ClippedElements::perimeter(std::size_t i, ConvertedPose<DoubleDouble>& pose) const {
  return enclosed_sum(perimeter_of(pose, elements_[i]), pose.field());
}

Ball ClippedElements::perimeter(std::size_t i, ConvertedPose<Ball>& pose) const {
  return enclosed_sum(perimeter_of(pose, elements_[i]), pose.field());
}

RadicalSum ClippedElements::perimeter(std::size_t i, ConvertedPose<Rational>& pose) const {
  return radical_sum(perimeter_of(pose, elements_[i]));
}

ElementGeometry<DoubleDouble> ClippedElements::geometry(std::size_t i, ConvertedPose<DoubleDouble>& pose) const {
  return enclosed_geometry(pose, elements_[i], max_penetration_);
}

ElementGeometry<Ball> ClippedElements::geometry(std::size_t i, ConvertedPose<Ball>& pose) const {
  return enclosed_geometry(pose, elements_[i], max_penetration_);
}

ElementGeometry<Dual<DoubleDouble>> ClippedElements::geometry(std::size_t i,
                                                              ConvertedPose<Dual<DoubleDouble>>& pose) const {
  return enclosed_geometry(pose, elements_[i], max_penetration_);
}

ElementGeometry<Dual<Ball>> ClippedElements::geometry(std::size_t i, ConvertedPose<Dual<Ball>>& pose) const {
  return enclosed_geometry(pose, elements_[i], max_penetration_);
}

ElementGeometry<Quadratic> ClippedElements::geometry(std::size_t i, ConvertedPose<Rational>& pose) const {
  const SeenPart<Rational> part = part_of(pose, elements_[i]);
  const ElementGeometry<Rational> g = geometry_of(part, pose.field());
  if (std::isinf(max_penetration_)) return converted(g);
  const Rational bound = pose.number(max_penetration_), square = dot(g.N, g.N);
  if (g.q_greatest * g.q_greatest * square <= bound * bound) return converted(g);
  const Quadratic q_max = Quadratic(bound) / sqrt(Quadratic(square));
  return clamped_geometry_of(converted(part), converted(g), q_max, Field<Quadratic>{});
}

}  // namespace pcm::reference
