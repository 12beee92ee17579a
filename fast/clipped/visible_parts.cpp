// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/visible_parts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "fast/clipped/line_beside_cut.h"

namespace pcm::fast {

namespace {

/// Whether one of a's sides has all of b on its far side. A corner that both share lies on its sides exactly.
bool side_separates(const ProjectedFace& a, const ProjectedFace& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const PrismPoint& from = a.corners[k];
    const PrismPoint& to = a.corners[(k + 1) % 3];
    if (cross_st(from, to, b.corners[0]) <= 0 && cross_st(from, to, b.corners[1]) <= 0 &&
        cross_st(from, to, b.corners[2]) <= 0) {
      return true;
    }
  }
  return false;
}

/// A linear function c_s (s - s_0) + c_t (t - t_0); a half plane is where it is not negative.
struct HalfPlane {
  double c_s, s_0, c_t, t_0;
  SideLine line;  ///< its border

  double operator()(const PrismPoint& x) const { return c_s * (x[kS] - s_0) + c_t * (x[kT] - t_0); }
};

constexpr std::size_t kMostHalfPlanes = ConvexPolygon::kMostCutsOfAFace;

/// A convex set of points, the intersection of half planes.
struct ConvexSet {
  std::array<HalfPlane, kMostHalfPlanes> half_planes;
  std::size_t count = 0;

  void add(const HalfPlane& half_plane) {
    assert(count < kMostHalfPlanes);
    half_planes[count++] = half_plane;
  }
  const HalfPlane* begin() const { return half_planes.data(); }
  const HalfPlane* end() const { return half_planes.data() + count; }
};

/// The inner side of side k of a counterclockwise face. The line runs from the vertex of smaller index to the other, so
/// that both faces at the edge have the same one.
HalfPlane inside_of_side(const ProjectedFace& face, std::size_t k) {
  const std::size_t next = (k + 1) % 3;
  const bool ascending = face.vertices[k] < face.vertices[next];
  const PrismPoint& a = face.corners[ascending ? k : next];
  const PrismPoint& b = face.corners[ascending ? next : k];
  const double sign = ascending ? 1 : -1;
  return {-sign * (b[kT] - a[kT]), a[kS], sign * (b[kS] - a[kS]), a[kT],
          line_of_face(face.number, static_cast<int>(k))};
}

/// Where the linear function with the given values at the corners of a face, some of them negative, not all, is not
/// negative. It is laid through the point where the function is 0 on the side from the corner P whose sign is its own
/// to the next one, a; b is where it is 0 on the other side from P. With e1, e2 the two sides and r1, r2 the function's
/// rise along them, the roundings of its gradient, r1 e2 - r2 e1 turned by a right angle, move what it tells of a point
/// between a and b by a few ulps of the longer of |a - P| and |b - P|, however narrow the face is.
HalfPlane where_not_negative(const ProjectedFace& face, const std::array<double, 3>& values, SideLine line) {
  const bool one_negative = (values[0] < 0) + (values[1] < 0) + (values[2] < 0) == 1;
  std::size_t lone = 0;
  while ((values[lone] < 0) != one_negative) ++lone;
  const std::size_t next = (lone + 1) % 3, last = (lone + 2) % 3;
  const PrismPoint& P = face.corners[lone];
  const PrismPoint& Q = face.corners[next];
  const PrismPoint e1 = Q - P, e2 = face.corners[last] - P;
  const double r1 = values[next] - values[lone], r2 = values[last] - values[lone];
  const PrismPoint a =
      one_negative ? point_at_zero(Q, values[next], P, values[lone]) : point_at_zero(P, values[lone], Q, values[next]);
  return {r1 * e2[kT] - r2 * e1[kT], a[kS], r2 * e1[kS] - r1 * e2[kS], a[kT], line};
}

Heights heights_of(const ConvexPolygon& polygon, const HalfPlane& half_plane) {
  Heights heights{};
  for (int i = 0; i < polygon.count; ++i) heights[static_cast<std::size_t>(i)] = half_plane(polygon[i]);
  return heights;
}

/// A convex polygon as half planes cut it, one after the other, until they are through or nothing is left of it.
struct Cuts {
  std::size_t count = 0;                                       ///< of half planes that cut
  std::array<const ConvexPolygon*, kMostHalfPlanes + 1> left;  ///< before cut k; the last one: after all of them
  std::array<Heights, kMostHalfPlanes> heights;                ///< values of cut k's half plane at left[k]'s vertices
  std::array<SideLine, kMostHalfPlanes> lines;                 ///< that it cuts along
  std::array<ConvexPolygon, kMostHalfPlanes> kept;             ///< what cut k leaves

  Cuts(const ConvexPolygon& polygon, const ConvexSet& set) {
    left[0] = &polygon;
    for (const HalfPlane& half_plane : set) {
      heights[count] = heights_of(*left[count], half_plane);
      if (!cut_where_negative(*left[count], heights[count], kept[count], half_plane.line)) continue;
      lines[count] = half_plane.line;
      left[count + 1] = &kept[count];
      ++count;
      if (common().empty()) break;
    }
  }
  Cuts(const Cuts&) = delete;
  Cuts& operator=(const Cuts&) = delete;

  /// What the polygon and the set have in common.
  const ConvexPolygon& common() const { return *left[count]; }
  /// Positive where cut k takes away.
  Heights outward(std::size_t k) const {
    Heights result = heights[k];
    for (int i = 0; i < left[k]->count; ++i) result[static_cast<std::size_t>(i)] *= -1;
    return result;
  }
  /// What cut k took away.
  ConvexPolygon outside(std::size_t k) const {
    ConvexPolygon taken = *left[k];
    keep_where_not_negative(taken, outward(k), lines[k]);
    return taken;
  }
};

double area_of(const ConvexPolygon& polygon) {
  return polygon.empty() ? 0 : 0.5 * std::abs(twice_area(polygon));
}

/// A piece in two, along a line that no face has: each then ends there only where the other one begins.
struct Halves {
  ConvexPolygon first, second;
  double lesser_area;

  /// From a vertex to a place on the side that begins as many sides after it. A line between two vertices may be an
  /// edge's, and that to the middle of a side as well, where faces make a grid.
  Halves(const ConvexPolygon& piece, int vertex, int sides) {
    constexpr double kAlongSide = 0.38196601125010515;  // the golden section
    const auto number = [&](int after) { return (vertex + after) % piece.count; };
    const auto line_from = [&](int after) { return piece.lines[static_cast<std::size_t>(number(after))]; };
    const PrismPoint &from = piece[number(sides)], &to = piece[number(sides + 1)];
    const PrismPoint end = from + kAlongSide * (to - from);
    first.cuts = second.cuts = piece.cuts + 1;  // the end is rounded as where a line cuts
    for (int k = 0; k <= sides; ++k) first.add(piece[number(k)], line_from(k));
    first.add(end);
    second.add(end, line_from(sides));
    for (int k = sides + 1; k < piece.count; ++k) second.add(piece[number(k)], line_from(k));
    second.add(piece[vertex]);
    lesser_area = std::min(area_of(first), area_of(second));
  }
};

/// Each with fewer vertices, and no sliver as long as there is another way: some vertices may lie in one place but for
/// roundings, or on one line.
Halves halves_of(const ConvexPolygon& piece) {
  Halves best(piece, 0, 2);
  for (int vertex = 0; vertex < piece.count; ++vertex) {
    for (int sides = 2; sides + 3 <= piece.count; ++sides) {
      const Halves halves(piece, vertex, sides);
      if (halves.lesser_area > best.lesser_area) best = halves;
    }
  }
  return best;
}

/// Appends a piece, in parts where it has too many vertices for the cuts to come.
void append(const ConvexPolygon& piece, std::vector<ConvexPolygon>& pieces) {
  if (piece.count <= ConvexPolygon::kMost) {
    pieces.push_back(piece);
    return;
  }
  const Halves halves = halves_of(piece);
  append(halves.first, pieces);
  append(halves.second, pieces);
}

/// Sides along cuts that took nothing but what was dropped lie on the lines that these cuts did not quite reach: the
/// cutting face may end before they do.
class Relabelling {
 public:
  void note(SideLine cut, SideLine beside) { lines_[count_++] = {cut, beside}; }
  void apply(ConvexPolygon& piece) const {
    for (std::size_t k = count_; k-- > 0;)
      std::replace(piece.lines.begin(), piece.lines.begin() + piece.count, lines_[k].cut, lines_[k].beside);
  }

 private:
  struct Lines {
    SideLine cut, beside;
  };
  std::array<Lines, kMostHalfPlanes> lines_;  ///< no cut is noted twice
  std::size_t count_ = 0;
};

/// Convex polygons without a convex set: what lies outside its first half plane, then of the rest what lies outside the
/// second, and so on.
void subtract(const ConvexSet& set, const Uncertainty& uncertainty, std::vector<ConvexPolygon>& pieces,
              std::vector<ConvexPolygon>& remaining, ClippingError& clipping_error) {
  remaining.clear();
  for (const ConvexPolygon& piece : pieces) {
    const Cuts cuts(piece, set);
    if (cuts.common().empty()) {
      remaining.push_back(piece);
      continue;
    }
    const std::size_t before = remaining.size();
    double dropped = 0;
    std::size_t certain_cut = 0;
    Relabelling relabelling;
    for (std::size_t k = 0; k < cuts.count; ++k) {
      ConvexPolygon outside = cuts.outside(k);
      if (certain(outside, uncertainty)) {
        relabelling.apply(outside);
        append(outside, remaining);
        certain_cut = k;
      } else {
        dropped += area_of(outside);
        const SideLine cut = cuts.lines[k];
        relabelling.note(cut, line_beside_cut(outside, *cuts.left[k], cuts.heights[k], cut));
      }
    }
    if (remaining.size() > before && !certain(cuts.common(), uncertainty)) {
      if (remaining.size() > before + 1) {
        remaining.resize(before);
        remaining.push_back(piece);
        dropped = area_of(cuts.common());
      } else {
        // What it left may end along an earlier cut that took nothing itself.
        const std::size_t k = certain_cut;
        const SideLine cut = cuts.lines[k];
        relabelling.note(cut, line_beside_cut(cuts.kept[k], *cuts.left[k], cuts.outward(k), cut));
        relabelling.apply(remaining.back());
      }
    }
    clipping_error.area += dropped;
  }
  std::swap(pieces, remaining);
}

/// Greatest difference and greatest value of a coordinate.
struct Extent {
  double width, high;

  Extent(const ConvexPolygon& polygon, int coordinate) : width(0), high(polygon[0][coordinate]) {
    double low = high;
    for (int i = 1; i < polygon.count; ++i) {
      low = std::min(low, polygon[i][coordinate]);
      high = std::max(high, polygon[i][coordinate]);
    }
    width = high - low;
  }
};

}  // namespace

void find_overlaps(const std::vector<ProjectedFace>& faces, std::vector<FaceExtent>& by_low_s,
                   std::vector<Overlap>& overlaps) {
  overlaps.clear();
  by_low_s.clear();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const ProjectedFace& face = faces[i];
    by_low_s.push_back({face.low_s, face.high_s, face.low_t, face.high_t, i, face.carries});
  }
  std::sort(by_low_s.begin(), by_low_s.end(), [](const FaceExtent& a, const FaceExtent& b) {
    return a.low_s < b.low_s || (a.low_s == b.low_s && a.index < b.index);
  });
  for (std::size_t i = 0; i < by_low_s.size(); ++i) {
    const FaceExtent& f = by_low_s[i];
    for (std::size_t j = i + 1; j < by_low_s.size() && by_low_s[j].low_s < f.high_s; ++j) {
      const FaceExtent& g = by_low_s[j];
      if (!(f.carries || g.carries) || !(f.low_s < g.high_s)) continue;
      if (!(f.low_t < g.high_t && g.low_t < f.high_t)) continue;
      if (side_separates(faces[f.index], faces[g.index]) || side_separates(faces[g.index], faces[f.index])) continue;
      if (f.carries) overlaps.emplace_back(f.index, g.index);
      if (g.carries) overlaps.emplace_back(g.index, f.index);
    }
  }
  std::sort(overlaps.begin(), overlaps.end());
}

void ClippingError::add_piece(const ConvexPolygon& piece, const ConvexPolygon& whole) {
  constexpr double u = 0x1p-53;
  ++pieces;
  const int seen = piece.cuts - whole.cuts;
  cuts = std::max(cuts, seen);
  const Extent s(piece, kS), t(piece, kT);
  const double off_s = (seen * (2 * Extent(whole, kS).width + 1) + 10 * s.width) * u;
  const double off_t = (seen * (2 * Extent(whole, kT).width + 1) + 10 * t.width) * u;
  const double changed = area_passed_by_border(s.width, t.width, off_s, off_t);
  cut_area += changed;
  cut_volume += changed * Extent(piece, kDepth).high;
}

void subtract_hidden(const PlacedFace& f, const PlacedFace& g, std::vector<ConvexPolygon>& pieces,
                     std::vector<ConvexPolygon>& remaining, ClippingError& clipping_error, WorkCounters& work) {
  std::array<double, 3> f_over_g;
  const Order order = order_of(g, f, f_over_g, work);
  if (order == Order::after) return;
  ConvexSet hidden;
  for (std::size_t k = 0; k < 3; ++k) hidden.add(inside_of_side(g.projected, k));
  const auto& corners = g.projected.corners;
  const std::array<double, 3> depths{corners[0][kDepth], corners[1][kDepth], corners[2][kDepth]};
  const auto line_of_g = [&g](int line) { return line_of_face(g.projected.number, line); };
  if (std::min({depths[0], depths[1], depths[2]}) < 0)
    hidden.add(where_not_negative(g.projected, depths, line_of_g(kAtDepth0)));
  // Points of f beyond g lie below it.
  if (order == Order::crossing) {
    hidden.add(where_not_negative(f.projected, {-f_over_g[0], -f_over_g[1], -f_over_g[2]}, line_of_g(kCrossing)));
  }
  const Uncertainty of_f = f.uncertainty(), of_g = g.uncertainty();
  subtract(hidden, {kSliver * std::max(of_f.s, of_g.s), kSliver * std::max(of_f.t, of_g.t)}, pieces, remaining,
           clipping_error);
}

}  // namespace pcm::fast
