// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

/// Convex polygons in the plane of a master face that carry a linear field, cut by lines and integrated (PCM section 6,
/// clipped scheme). No tolerance anywhere: cuts that miss by a rounding make slivers of an area as small, which are
/// told by a bound of that error.
namespace pcm::fast {

/// A point x as a master face (p0, p1, p2) sees it: x = p0 + s (p1 - p0) + t (p2 - p0) - depth n. The first three
/// entries are the weights of p0, p1 and p2 (1 - s - t, s and t, each computed for itself), the last is the depth, m.
using PrismPoint = Eigen::Vector4d;
inline constexpr int kS = 1;
inline constexpr int kT = 2;
inline constexpr int kDepth = 3;

/// Twice the area of the triangle (a, b, c) in (s, t): positive where it turns as the face itself.
inline double cross_st(const PrismPoint& a, const PrismPoint& b, const PrismPoint& c) {
  return (b[kS] - a[kS]) * (c[kT] - a[kT]) - (b[kT] - a[kT]) * (c[kS] - a[kS]);
}

/// The line that a side of a polygon lies on: of which face, and where it comes from; kNoLine for one that nothing of
/// the slave moves, a side of the master or one between two halves of a piece.
using SideLine = std::int32_t;
inline constexpr SideLine kNoLine = 0;
/// 0 to 2: the face's edges, from the corner of that number on.
inline constexpr int kAtDepth0 = 3;  ///< where the face passes through the master's plane
inline constexpr int kCrossing = 4;  ///< where it passes through the face that is cut
inline constexpr int kLinesOfAFace = 5;
inline SideLine line_of_face(std::int32_t face, int line) {
  return 1 + kLinesOfAFace * face + line;
}

/// A convex polygon in (s, t), counterclockwise, with the depth at its vertices. Fewer than three vertices: empty.
struct ConvexPolygon {
  /// Most vertices a part may have: a triangle cut by the face's three sides and at depth 0 has seven.
  static constexpr int kMost = 7;
  /// Cuts of one other face: by its three sides, at depth 0, and where the two cross.
  static constexpr int kMostCutsOfAFace = 5;
  /// Room for as many, each of which adds at most one vertex.
  static constexpr int kCapacity = kMost + kMostCutsOfAFace;

  std::array<PrismPoint, kCapacity> points;
  std::array<SideLine, kCapacity> lines;  ///< of the sides from each vertex to the next
  int count;
  int cuts;  ///< that made it what it is: each of them rounds

  ConvexPolygon() : count(0), cuts(0) {}
  /// Only the vertices there are.
  ConvexPolygon(const ConvexPolygon& other) : count(other.count), cuts(other.cuts) {
    std::copy_n(other.points.begin(), count, points.begin());
    std::copy_n(other.lines.begin(), count, lines.begin());
  }
  ConvexPolygon& operator=(const ConvexPolygon& other) {
    count = other.count;
    cuts = other.cuts;
    std::copy_n(other.points.begin(), count, points.begin());
    std::copy_n(other.lines.begin(), count, lines.begin());
    return *this;
  }

  void add(const PrismPoint& point, SideLine line = kNoLine) {
    lines[static_cast<std::size_t>(count)] = line;
    points[static_cast<std::size_t>(count++)] = point;
  }
  const PrismPoint& operator[](int i) const { return points[static_cast<std::size_t>(i)]; }
  PrismPoint& operator[](int i) { return points[static_cast<std::size_t>(i)]; }
  bool empty() const { return count < 3; }
  /// The vertex after vertex i.
  int next(int i) const { return i + 1 == count ? 0 : i + 1; }
};

/// About each corner of a convex polygon that may be off by up to (s, t): 2 s times 2 t.
inline double area_about_corners(double s, double t) {
  return 4.0 * ConvexPolygon::kCapacity * s * t;
}

/// What the border of a convex polygon passes over when its corners are shifted by up to (s, t): each side |side_s| t +
/// |side_t| s, all of them together twice what the polygon is wide in s and in t; and what is about the corners.
inline double area_passed_by_border(double width_s, double width_t, double s, double t) {
  return 2 * (width_s * t + width_t * s) + area_about_corners(s, t);
}

/// A linear function's values at a polygon's vertices.
using Heights = std::array<double, ConvexPolygon::kCapacity>;

/// Where a linear function is 0 between a (height >= 0) and b (height < 0), reckoned from the nearer of the two. Both
/// neighbours at an edge see the same ends, so they get the same bits.
inline PrismPoint point_at_zero(const PrismPoint& a, double height_a, const PrismPoint& b, double height_b) {
  const double difference = height_a - height_b;
  if (height_a <= -height_b) return a + (height_a / difference) * (b - a);
  return b + (-height_b / difference) * (a - b);
}

/// The vertices of a polygon that a cut leaves, from first to last, and the next ones on either side, which it takes.
struct KeptVertices {
  int before, first, last, after;

  /// `top`: where the linear function is greatest, and positive; it is negative somewhere. Along the border of a convex
  /// polygon it rises and falls once; what rounding adds to that is taken as outside, so that at most one vertex joins.
  KeptVertices(const ConvexPolygon& polygon, const Heights& heights, int top) : first(top), last(top) {
    const auto at = [&heights](int i) { return heights[static_cast<std::size_t>(i)]; };
    const auto previous = [&polygon](int i) { return i == 0 ? polygon.count - 1 : i - 1; };
    for (before = previous(first); at(before) >= 0; before = previous(before)) first = before;
    for (after = polygon.next(last); at(after) >= 0; after = polygon.next(after)) last = after;
  }
};

/// Fills `kept`, another polygon, with what a cut where the linear function is negative leaves. False where it is
/// negative at no vertex: the polygon stays whole then, and `kept` untouched. The side along the cut lies on `line`.
inline bool cut_where_negative(const ConvexPolygon& polygon, const Heights& heights, ConvexPolygon& kept,
                               SideLine line = kNoLine) {
  const int n = polygon.count;
  int top = 0;
  bool all = true;
  for (int i = 0; i < n; ++i) {
    const double height = heights[static_cast<std::size_t>(i)];
    all = all && height >= 0;
    if (height > heights[static_cast<std::size_t>(top)]) top = i;
  }
  if (all) return false;
  const auto at = [&heights](int i) { return heights[static_cast<std::size_t>(i)]; };
  kept.cuts = polygon.cuts + 1;
  kept.count = 0;
  if (!(at(top) > 0)) return true;
  const auto [before, first, last, after] = KeptVertices(polygon, heights, top);
  // Counted apart from the polygon, so that storing points need not wait for it.
  std::size_t count = 0;
  const auto line_from = [&polygon](int i) { return polygon.lines[static_cast<std::size_t>(i)]; };
  if (at(first) > 0) {
    kept.lines[count] = line_from(before);
    kept.points[count++] = point_at_zero(polygon[first], at(first), polygon[before], at(before));
  }
  for (int i = first; i != after; i = polygon.next(i)) {
    kept.lines[count] = line_from(i);
    kept.points[count++] = polygon[i];
  }
  if (at(last) > 0) kept.points[count++] = point_at_zero(polygon[last], at(last), polygon[after], at(after));
  kept.lines[count - 1] = line;
  kept.count = static_cast<int>(count);
  return true;
}

/// Cuts away where the linear function is negative.
inline void keep_where_not_negative(ConvexPolygon& polygon, const Heights& heights, SideLine line = kNoLine) {
  ConvexPolygon kept;
  if (cut_where_negative(polygon, heights, kept, line)) polygon = kept;
}

/// Cuts away where one of the coordinates is negative.
inline void keep_where_not_negative(ConvexPolygon& polygon, int coordinate, SideLine line = kNoLine) {
  Heights heights;
  for (int i = 0; i < polygon.count; ++i) heights[static_cast<std::size_t>(i)] = polygon[i][coordinate];
  keep_where_not_negative(polygon, heights, line);
}

/// How far points may be off in s and t through roundings, none of which is a tolerance: an error bound.
struct Uncertainty {
  double s = 0;
  double t = 0;
};

/// Twice the area of a polygon in (s, t).
inline double twice_area(const ConvexPolygon& polygon) {
  double sum = 0;
  for (int i = 1; i + 1 < polygon.count; ++i) sum += cross_st(polygon[0], polygon[i], polygon[i + 1]);
  return sum;
}

/// Whether a polygon that covers `area` and is so wide has area however its points are off within the uncertainty. One
/// that may have none counts as none: its mean or greatest depth would mean nothing, and cutting with it would only
/// make more of its kind.
inline bool certain(double area, double width_s, double width_t, const Uncertainty& uncertainty) {
  return area > width_t * uncertainty.s + width_s * uncertainty.t;
}

inline bool certain(const ConvexPolygon& polygon, const Uncertainty& uncertainty) {
  if (polygon.empty()) return false;
  double low_s = polygon[0][kS], high_s = low_s, low_t = polygon[0][kT], high_t = low_t;
  for (int i = 1; i < polygon.count; ++i) {
    low_s = std::min(low_s, polygon[i][kS]);
    high_s = std::max(high_s, polygon[i][kS]);
    low_t = std::min(low_t, polygon[i][kT]);
    high_t = std::max(high_t, polygon[i][kT]);
  }
  return certain(0.5 * twice_area(polygon), high_s - low_s, high_t - low_t, uncertainty);
}

/// Integrals over polygons in (s, t), exact for their linear field.
struct Moments {
  double area = 0;      ///< of 1; a whole face has 1/2
  double depth = 0;     ///< of the depth, m
  double s_depth = 0;   ///< of s times the depth, m
  double t_depth = 0;   ///< of t times the depth, m
  double greatest = 0;  ///< greatest depth at a vertex, m

  /// A fan of triangles about the first vertex. Over a triangle of area T a linear function integrates to T times the
  /// mean of its corner values, the product x d of two to T / 12 (sum x sum d + sum of x_i d_i).
  void add(const ConvexPolygon& polygon) {
    const PrismPoint& a = polygon[0];
    greatest = std::max(greatest, a[kDepth]);
    for (int i = 1; i < polygon.count; ++i) {
      const PrismPoint& b = polygon[i];
      greatest = std::max(greatest, b[kDepth]);
      if (i + 1 == polygon.count) break;
      const PrismPoint& c = polygon[i + 1];
      const double triangle = 0.5 * cross_st(a, b, c);
      const PrismPoint sum = a + b + c;
      area += triangle;
      depth += triangle * (sum[kDepth] / 3);
      const double twelfth = triangle / 12;
      s_depth += twelfth * (sum[kS] * sum[kDepth] + a[kS] * a[kDepth] + b[kS] * b[kDepth] + c[kS] * c[kDepth]);
      t_depth += twelfth * (sum[kT] * sum[kDepth] + a[kT] * a[kDepth] + b[kT] * b[kDepth] + c[kT] * c[kDepth]);
    }
  }

  /// The same of min(depth, most). Each triangle of the fan is parted where it is that deep: along three corners the
  /// difference changes its sign no more than twice, so that nothing gets lost between both parts, even of a polygon
  /// that lies at that depth but for roundings. What lies at that depth exactly is of the shallow part.
  void add_clamped(const ConvexPolygon& polygon, double most) {
    for (int i = 1; i + 1 < polygon.count; ++i) {
      ConvexPolygon shallow;
      for (const int corner : {0, i, i + 1}) shallow.add(polygon[corner]);
      ConvexPolygon deep = shallow;
      Heights above, below;
      for (std::size_t k = 0; k < 3; ++k) {
        above[k] = most - shallow.points[k][kDepth];
        below[k] = -above[k];
      }
      keep_where_not_negative(shallow, above);
      if (std::max({below[0], below[1], below[2]}) > 0) {
        keep_where_not_negative(deep, below);
      } else {
        deep.count = 0;
      }
      for (int k = 0; k < shallow.count; ++k) shallow[k][kDepth] = std::min(shallow[k][kDepth], most);
      for (int k = 0; k < deep.count; ++k) deep[k][kDepth] = most;
      for (const ConvexPolygon* const part : {&shallow, &deep}) {
        if (!part->empty()) add(*part);
      }
    }
  }
};

}  // namespace pcm::fast
