// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/visible_parts.h"

#include <algorithm>
#include <utility>

namespace pcm::fast {

namespace {

/// Where a face lies along the lines, compared with another one.
enum class Order : std::uint8_t { before, after, crossing };

/// A linear function c + c_s (s - s_0) + c_t (t - t_0) + c_depth depth; a half space is where it is not negative.
struct HalfSpace {
  double c, c_s, s_0, c_t, t_0, c_depth;

  double operator()(const PrismPoint& x) const {
    return c + (c_s * (x[kS] - s_0) + c_t * (x[kT] - t_0)) + c_depth * x[kDepth];
  }
};

/// A convex set of points, the intersection of half spaces.
struct ConvexSet {
  std::array<HalfSpace, 5> half_spaces;
  std::size_t count = 0;

  void add(const HalfSpace& half_space) { half_spaces[count++] = half_space; }
  const HalfSpace* begin() const { return half_spaces.data(); }
  const HalfSpace* end() const { return half_spaces.data() + count; }
};

/// The inner side of side k of a counterclockwise face. The line runs from the vertex of smaller index to the other,
/// so that both faces at the edge have the same one.
HalfSpace inside_of_side(const ProjectedFace& face, std::size_t k) {
  const std::size_t next = (k + 1) % 3;
  const bool ascending = face.vertices[k] < face.vertices[next];
  const PrismPoint& a = face.corners[ascending ? k : next];
  const PrismPoint& b = face.corners[ascending ? next : k];
  const double sign = ascending ? 1 : -1;
  return {0, -sign * (b[kT] - a[kT]), a[kS], sign * (b[kS] - a[kS]), a[kT], 0};
}

/// `sign` times the height of points over the plane of f; with depth 0 where `in_plane`, the height of their feet.
HalfSpace height_over(const MasterPrism& prism, const PlacedFace& f, double sign, bool in_plane) {
  const auto& p = f.points_Me;
  const Eigen::Vector3d N = sign * (p[1] - p[0]).cross(p[2] - p[0]);
  return {N.dot(prism.p0_Me() - p[0]),
          N.dot(prism.edge_s_Me()),
          0,
          N.dot(prism.edge_t_Me()),
          0,
          in_plane ? 0 : -N.dot(prism.face().n_Me)};
}

/// On which side of the plane of f the vertices of g lie: 1 above or in it, -1 below or in it, 0 all in it, 2 both.
/// "Above" is where the lines come from: the vertices of f run counterclockwise as the master sees them.
int side_of_plane(const PlacedFace& f, const PlacedFace& g, WorkCounters& work) {
  bool above = false, below = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& shared = f.projected.vertices;
    const bool is_corner = f.projected.own == g.projected.own &&
                           std::find(shared.begin(), shared.end(), g.projected.vertices[k]) != shared.end();
    const int sign = is_corner ? 0 : height_sign(f.points_Me, g.points_Me[k], work);
    above = above || sign > 0;
    below = below || sign < 0;
  }
  return above && below ? 2 : above ? 1 : below ? -1 : 0;
}

Order order_of(const PlacedFace& g, const PlacedFace& f, WorkCounters& work) {
  const int g_over_f = side_of_plane(f, g, work);
  if (g_over_f == 0) {
    return !g.projected.own && g.projected.face < f.projected.face ? Order::before : Order::after;
  }
  if (g_over_f != 2) return g_over_f > 0 ? Order::before : Order::after;
  const int f_over_g = side_of_plane(g, f, work);
  if (f_over_g != 2) return f_over_g > 0 ? Order::after : Order::before;
  return Order::crossing;
}

Heights heights_of(const ConvexPolygon& polygon, const HalfSpace& half_space) {
  Heights heights{};
  for (int i = 0; i < polygon.count; ++i) heights[static_cast<std::size_t>(i)] = half_space(polygon[i]);
  return heights;
}

bool meets(ConvexPolygon polygon, const ConvexSet& set) {
  for (const HalfSpace& half_space : set) {
    keep_where_not_negative(polygon, heights_of(polygon, half_space));
    if (polygon.empty()) return false;
  }
  return true;
}

/// Appends a part, in two where it has too many vertices for the cuts to come.
void append(const ConvexPolygon& part, std::vector<ConvexPolygon>& parts) {
  if (part.empty()) return;
  if (part.count <= ConvexPolygon::kMost) {
    parts.push_back(part);
    return;
  }
  const int half = part.count / 2;
  ConvexPolygon first, second;
  for (int i = 0; i <= half; ++i) first.add(part[i]);
  for (int i = half; i < part.count; ++i) second.add(part[i]);
  second.add(part[0]);
  parts.push_back(first);
  parts.push_back(second);
}

/// Convex polygons without a convex set: what lies outside its first half space, then of the rest what lies outside the
/// second, and so on.
void subtract(const ConvexSet& set, std::vector<ConvexPolygon>& parts, std::vector<ConvexPolygon>& remaining) {
  remaining.clear();
  for (const ConvexPolygon& part : parts) {
    if (!meets(part, set)) {
      remaining.push_back(part);
      continue;
    }
    ConvexPolygon rest = part;
    for (const HalfSpace& half_space : set) {
      Heights heights = heights_of(rest, half_space);
      if (*std::min_element(heights.begin(), heights.begin() + rest.count) >= 0) continue;
      ConvexPolygon outside = rest;
      keep_where_not_negative(rest, heights);
      for (double& height : heights) height = -height;
      keep_where_not_negative(outside, heights);
      append(outside, remaining);
      if (rest.empty()) break;
    }
  }
  std::swap(parts, remaining);
}

}  // namespace

void subtract_hidden(const MasterPrism& prism, const PlacedFace& f, const PlacedFace& g,
                     std::vector<ConvexPolygon>& parts, std::vector<ConvexPolygon>& remaining, WorkCounters& work) {
  const Order order = order_of(g, f, work);
  if (order == Order::after) return;
  ConvexSet hidden;
  for (std::size_t k = 0; k < 3; ++k) hidden.add(inside_of_side(g.projected, k));
  const auto& corners = g.projected.corners;
  // Points of the plane of g at a depth >= 0 have their feet above it.
  if (std::min({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth]}) < 0) {
    hidden.add(height_over(prism, g, 1, true));
  }
  // Points of f beyond g lie below it.
  if (order == Order::crossing) hidden.add(height_over(prism, g, -1, false));
  subtract(hidden, parts, remaining);
}

}  // namespace pcm::fast
