// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/hiding_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "fast/clipped/cut_stretches.h"
#include "fast/clipped/placed_face.h"
#include "fast/clipped/seen_edge.h"
#include "fast/predicates/orientation.h"

namespace pcm::fast {

namespace {

/// The slopes of a linear function of (s, t).
struct Slope {
  double per_s, per_t;

  explicit Slope(const ProjectedFace& face) {
    const PrismPoint s = face.corners[1] - face.corners[0], t = face.corners[2] - face.corners[0];
    const double twice_area = s[kS] * t[kT] - s[kT] * t[kS];
    per_s = (s[kDepth] * t[kT] - t[kDepth] * s[kT]) / twice_area;
    per_t = (t[kDepth] * s[kS] - s[kDepth] * t[kS]) / twice_area;
  }
  Slope(double by_s, double by_t) : per_s(by_s), per_t(by_t) {}

  double along(const PrismPoint& way) const { return per_s * way[kS] + per_t * way[kT]; }
  /// To the right of a way.
  double to_the_right(const PrismPoint& way) const { return per_s * way[kT] - per_t * way[kS]; }
};

/// A way along f that lies where something begins to hide it.
class Border {
 public:
  /// `near_side`: where the way is an edge of f from which on f is hidden, the face of its sheet that is seen before
  /// it.
  Border(const SeenFaces& seen, const PrismPoint& a, const PrismPoint& b, const ProjectedFace* near_side = nullptr)
      : seen_(seen),
        a_(a),
        b_(b),
        way_(b - a),
        wider_(std::abs(way_[kS]) >= std::abs(way_[kT]) ? kS : kT),
        near_side_(near_side) {}

  /// f's own, which it lies to the left of; in its place what begins there to hide the sheet that goes on.
  std::optional<PartOnLine> on_edge_of_f(SeenBeyond& seen_beyond) const {
    const ProjectedFace& f = seen_.f;
    const Uncertainty uncertainty = seen_.prism.uncertainty(f.corners, seen_.posed.placement.max_coordinate);
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const PrismPoint &from = f.corners[edge], &to = f.corners[(edge + 1) % 3];
      if (!lie_on_line(a_, b_, from, to, uncertainty)) continue;
      const auto part = part_on(f, static_cast<int>(edge), {share_of(from), share_of(to)}, uncertainty);
      if (!part) continue;
      const ProjectedFace* const next = hidden_neighbour(seen_, edge);
      const auto hiding = next != nullptr ? hiding_neighbour(*next, *part) : std::nullopt;
      if (!hiding) return part;
      const auto beside_seen = where_seen_beyond(*next, f, edge, *hiding, uncertainty, seen_beyond);
      return beside_seen ? beside_seen : hiding;
    }
    return {};
  }

  /// Of f's edge, beyond which `next` is hidden: where f passes through what hides it there, if that is no more than
  /// roundings before the edge; else what hides `next`.
  std::optional<PartOnLine> hiding_neighbour(const ProjectedFace& next, const PartOnLine& edge) const {
    const SeenFaces of_sheet = seen_with(next);
    const PrismPoint first = at(edge.from), last = at(edge.to);
    const Border of_f(seen_, first, last), of_next(of_sheet, first, last, &seen_.f);
    for (const Overlap& overlap : overlaps_of(seen_, next)) {
      const ProjectedFace& h = seen_.faces[overlap.second];
      if (h.number == seen_.f.number) continue;
      auto part = of_f.on_crossing_of(h);
      if (!part || !goes_through(h)) part = of_next.on_line_of(h);
      const double length = edge.to - edge.from;
      if (part)
        return PartOnLine{part->line, edge.from + part->from * length, edge.from + part->to * length, part->hidden};
    }
    return {};
  }

  /// A stretch of that part on f's edge along which something of `next` is seen.
  std::optional<PartOnLine> where_seen_beyond(const ProjectedFace& next, const ProjectedFace& f, std::size_t edge,
                                              const PartOnLine& part, const Uncertainty& uncertainty,
                                              SeenBeyond& seen_beyond) const {
    // Both faces run through their common edge, one against the other.
    std::size_t edge_of_next = 0;
    while (next.vertices[edge_of_next] != f.vertices[(edge + 1) % 3]) ++edge_of_next;
    const SideLine line = line_of_face(next.number, static_cast<int>(edge_of_next));
    for (const ConvexPolygon& piece : seen_beyond.pieces(seen_with(next))) {
      for (int i = 0; i < piece.count; ++i) {
        if (piece.lines[static_cast<std::size_t>(i)] != line) continue;
        const Places shares{std::max(share_of(piece[piece.next(i)]), part.from), std::min(share_of(piece[i]), part.to)};
        if (const auto seen = part_on(f, static_cast<int>(edge), shares, uncertainty)) return seen;
      }
    }
    return {};
  }

  /// Where it passes through f.
  std::optional<PartOnLine> on_crossing_of(const ProjectedFace& h) const {
    const Uncertainty uncertainty = seen_.prism.uncertainty(h.corners, seen_.posed.placement.max_coordinate);
    if (is_seen_edgewise(h, uncertainty)) return {};
    const Slope depth(h);
    const double depth_at_a = h.corners[0][kDepth] + depth.along(a_ - h.corners[0]);
    const auto part = on_level(h, kCrossing, a_[kDepth] - depth_at_a, lead(depth), uncertainty);
    return part && pass_through_each_other(seen_.f, h) ? part : std::nullopt;
  }

  /// First where it passes through f, and where through the master: an edge may lie just there.
  std::optional<PartOnLine> on_line_of(const ProjectedFace& h) const {
    const Uncertainty uncertainty = seen_.prism.uncertainty(h.corners, seen_.posed.placement.max_coordinate);
    if (is_seen_edgewise(h, uncertainty)) return {};
    if (const auto crossing = on_crossing_of(h)) return crossing;
    const Slope depth(h);
    const double depth_at_a = h.corners[0][kDepth] + depth.along(a_ - h.corners[0]);
    if (passes_through_master(h))
      if (const auto part = on_level(h, kAtDepth0, depth_at_a, depth, uncertainty)) return part;
    for (std::size_t edge = 0; edge < 3; ++edge)
      if (const auto part = on_edge(h, edge, uncertainty)) return part;
    return {};
  }

 private:
  SeenFaces seen_with(const ProjectedFace& next) const {
    return {seen_.posed, seen_.master, seen_.master_face, seen_.prism, seen_.faces, seen_.overlaps, next};
  }
  /// All of it, though it may reach beyond the master: to within roundings it has no area.
  static bool is_seen_edgewise(const ProjectedFace& h, const Uncertainty& uncertainty) {
    const std::array<PrismPoint, 3>& x = h.corners;
    const auto width = [&x](int weight) {
      return std::max({x[0][weight], x[1][weight], x[2][weight]}) -
             std::min({x[0][weight], x[1][weight], x[2][weight]});
    };
    return !certain(0.5 * cross_st(x[0], x[1], x[2]), width(kS), width(kT), uncertainty);
  }
  /// Of a face with these slopes of its depth: before f it lies where this is positive.
  Slope lead(const Slope& depth) const {
    const Slope f(seen_.f);
    return {f.per_s - depth.per_s, f.per_t - depth.per_t};
  }
  PlacedFace placed(const ProjectedFace& face) const {
    return placed_face(seen_.posed, seen_.master, seen_.prism, face);
  }
  bool pass_through_each_other(const ProjectedFace& f, const ProjectedFace& h) const {
    const PlacedFace placed_f = placed(f), placed_h = placed(h);
    return meet_in_line(heights_over(placed_f, placed_h, seen_.posed.work)) &&
           meet_in_line(heights_over(placed_h, placed_f, seen_.posed.work));
  }
  /// Whether f lies on both sides of the plane of h, rather than touch it with an edge.
  bool goes_through(const ProjectedFace& h) const {
    const std::array<double, 3> heights = heights_over(placed(h), placed(seen_.f), seen_.posed.work);
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    return *low < 0 && *high > 0;
  }
  /// Through f; or through the face on the near side of its edge, by what roundings may leave between that line and it.
  bool passes_through_sheet(const ProjectedFace& h) const {
    return pass_through_each_other(seen_.f, h) || (near_side_ != nullptr && pass_through_each_other(*near_side_, h));
  }
  static bool passes_through_master(const ProjectedFace& h) {
    return meet_in_line({h.corners[0][kDepth], h.corners[1][kDepth], h.corners[2][kDepth]});
  }
  /// Whether a linear function that is 0 on the way rises over h by more than roundings of depths.
  bool rises_over(const ProjectedFace& h, const Slope& slope) const {
    double low = 0, high = 0;
    for (const PrismPoint& corner : h.corners) {
      low = std::min(low, slope.along(corner - a_));
      high = std::max(high, slope.along(corner - a_));
    }
    return high - low > kLevel * greatest_depth(h);
  }
  /// On the way and at the corners of h.
  double greatest_depth(const ProjectedFace& h) const {
    double depth = std::max(std::abs(a_[kDepth]), std::abs(b_[kDepth]));
    for (const PrismPoint& corner : h.corners) depth = std::max(depth, std::abs(corner[kDepth]));
    return depth;
  }
  /// Of depths on the way and at the corners of h, m: a height N . (x - p0) is off by kFilterRelative of what its terms
  /// add up to, which is no more than sqrt(3) |N| |x - p0|.
  double depth_error(const ProjectedFace& h) const {
    const double edge_s = seen_.prism.edge_s_Me().norm(), edge_t = seen_.prism.edge_t_Me().norm();
    const auto distance = [&](const PrismPoint& x) {
      return std::abs(x[kS]) * edge_s + std::abs(x[kT]) * edge_t + std::abs(x[kDepth]);
    };
    double farthest = std::max(distance(a_), distance(b_));
    for (const PrismPoint& corner : h.corners) farthest = std::max(farthest, distance(corner));
    return 1.75 * kFilterRelative * farthest;
  }
  PrismPoint at(double share) const { return a_ + share * way_; }
  double share_of(const PrismPoint& x) const { return (x[wider_] - a_[wider_]) / way_[wider_]; }

  std::optional<PartOnLine> part_on(const ProjectedFace& h, int kind, const Places& shares,
                                    const Uncertainty& uncertainty) const {
    const double from = std::max(shares.first, 0.0), to = std::min(shares.last, 1.0);
    if (!(from < to) || !are_apart(at(from), at(to), uncertainty)) return {};
    return PartOnLine{line_of_face(h.number, kind), from, to, &seen_.f};
  }

  /// Of an edge of h that lies on the way.
  Places places_before_f(const ProjectedFace& h, const SeenEdge& edge) const {
    if (edge.standing(a_, edge.place(a_), b_, edge.place(b_)) != SeenEdge::Standing::level) return edge.before(a_, b_);
    if (passes_through_sheet(h)) {
      // One that comes to the edge from behind f hides nothing beyond it.
      const bool may_hide = near_side_ == nullptr || lead(Slope(h)).to_the_right(way_) > 0;
      return may_hide ? edge.before(a_, b_) : Places{0, 0};
    }
    std::array<double, 3> f_over_h{};
    const Order order = order_of(placed(h), placed(seen_.f), f_over_h, seen_.posed.work);
    return order == Order::before ? edge.beneath_master() : Places{0, 0};
  }

  /// What it hides lies on the left of its edge, so that this runs against the way.
  std::optional<PartOnLine> on_edge(const ProjectedFace& h, std::size_t edge, const Uncertainty& uncertainty) const {
    const PrismPoint &from = h.corners[edge], &to = h.corners[(edge + 1) % 3];
    if (!((to[kS] - from[kS]) * way_[kS] + (to[kT] - from[kT]) * way_[kT] < 0)) return {};
    if (!lie_on_line(a_, b_, from, to, uncertainty)) return {};
    const Places places = places_before_f(h, SeenEdge(h, edge));
    const auto share = [&](double place) { return share_of(from + place * (to - from)); };
    return part_on(h, static_cast<int>(edge), {share(places.last), share(places.first)}, uncertainty);
  }

  /// Where a linear function is 0 that is positive where h hides f, `at_a` its value there.
  std::optional<PartOnLine> on_level(const ProjectedFace& h, int kind, double at_a, const Slope& slope,
                                     const Uncertainty& uncertainty) const {
    const double error =
        std::abs(slope.per_s) * uncertainty.s + std::abs(slope.per_t) * uncertainty.t + 2 * depth_error(h);
    if (!(slope.to_the_right(way_) > 0) || !(std::abs(at_a) <= error) || !(std::abs(at_a + slope.along(way_)) <= error))
      return {};
    if (!rises_over(h, slope)) return {};
    Places shares{0, 1};
    for (std::size_t k = 0; k < 3; ++k) {
      const PrismPoint &from = h.corners[k], &to = h.corners[(k + 1) % 3];
      const double beside =
          2 * (std::abs(to[kT] - from[kT]) * uncertainty.s + std::abs(to[kS] - from[kS]) * uncertainty.t);
      shares = shares.where_not_negative(cross_st(from, to, a_) + beside, cross_st(from, to, b_) + beside);
    }
    return part_on(h, kind, shares, uncertainty);
  }

  const SeenFaces& seen_;
  const PrismPoint &a_, &b_;
  PrismPoint way_;
  int wider_;
  const ProjectedFace* near_side_;
};

}  // namespace

const std::vector<ConvexPolygon>& SeenBeyond::pieces(const SeenFaces& beyond) {
  if (face_ == &beyond.f) return pieces_;
  face_ = &beyond.f;
  ClippingError clipping_error;
  find_visible_pieces(beyond, pieces_, remaining_, clipping_error);
  return pieces_;
}

Index face_beyond(const SeenFaces& seen, std::size_t edge) {
  const PreparedSurface& slave = seen.posed.surface(opposite(seen.master));
  const Triangle& vertices = slave.face(seen.f.face);
  const auto is_on_edge = [&](Index v) { return v == seen.f.vertices[edge] || v == seen.f.vertices[(edge + 1) % 3]; };
  std::size_t k = 0;
  while (is_on_edge(vertices[k])) ++k;
  return slave.neighbours_of(seen.f.face)[(k + 1) % 3];
}

const ProjectedFace* carrying_face(const SeenFaces& seen, Index face) {
  const auto found =
      std::lower_bound(seen.faces.begin(), seen.faces.end(), face,
                       [](const ProjectedFace& one, Index number) { return !one.of_master && one.face < number; });
  if (found == seen.faces.end() || found->of_master || found->face != face || !found->carries) return nullptr;
  return &*found;
}

const ProjectedFace* hidden_neighbour(const SeenFaces& seen, std::size_t edge) {
  if (seen.overlaps.empty()) return nullptr;
  const Index next = face_beyond(seen, edge);
  const ProjectedFace* const face = next == seen.f.face ? nullptr : carrying_face(seen, next);
  return face != nullptr && !overlaps_of(seen, *face).empty() ? face : nullptr;
}

std::optional<PartOnLine> find_hiding_line(const SeenFaces& seen, const PrismPoint& a, const PrismPoint& b,
                                           SeenBeyond& beyond) {
  const Border border(seen, a, b);
  if (const auto part = border.on_edge_of_f(beyond)) return part;
  for (const ProjectedFace& h : seen.faces) {
    if (h.number == seen.f.number) continue;
    if (const auto part = border.on_line_of(h)) return part;
  }
  return {};
}

}  // namespace pcm::fast
