// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/part_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "fast/clipped/face_depth.h"
#include "fast/clipped/face_view.h"
#include "fast/clipped/seen_edge.h"

namespace pcm::fast {

namespace {

using Eigen::Vector3d;

/// Whether some edge of a face may lie on the border of the master, to within roundings that are no greater than this.
bool may_have_edge_on_border(const ProjectedFace& f) {
  constexpr double kNear = 0x1p-10;
  bool any = false;
  for (int weight = 0; weight < 3; ++weight) {
    int near = 0;
    for (const PrismPoint& corner : f.corners) near += std::abs(corner[weight]) <= kNear ? 1 : 0;
    any = any || near >= 2;
  }
  return any;
}

/// Where a part's centre of pressure is.
struct Centre {
  double s, t;
};

/// The integrals over what is seen, and how they change as the slave moves: of 1, of the clamped depth, and of that
/// times s and t reckoned from the centre of pressure. A part that is small beside its master is far from p0, and
/// lengths from there to the part, squared, would be rounded.
enum Integral { kOne, kDepths, kSDepths, kTDepths, kIntegrals };
using IntegralSlopes = std::array<MotionSlope, kIntegrals>;

/// Their integrands at a place. No vector of Eigen's: a processor that has stored number by number has to wait before
/// it can load several of them as one.
using Integrands = std::array<double, kIntegrals>;

bool is_finite(const MotionSlope& slope) {
  const Vector3d no_number = 0 * slope.by_position + 0 * slope.by_rotation;
  return no_number[0] + no_number[1] + no_number[2] == 0;
}

/// Of a / b, where `quotient` is its value.
MotionSlope of_quotient(const MotionSlope& a, double b, const MotionSlope& by_b, double quotient) {
  return {(a.by_position - quotient * by_b.by_position) / b, (a.by_rotation - quotient * by_b.by_rotation) / b};
}

/// Integrals over polygons of what Moments leaves out: s, t and their products, reckoned from a centre.
struct PlaceMoments {
  Centre centre;
  double s = 0, t = 0, ss = 0, st = 0, tt = 0;

  void add(const ConvexPolygon& polygon) {
    for (int i = 1; i + 1 < polygon.count; ++i) add(polygon[0], polygon[i], polygon[i + 1]);
  }
  void add(const PrismPoint& a, const PrismPoint& b, const PrismPoint& c) {
    const double area = 0.5 * cross_st(a, b, c), third = area / 3, twelfth = area / 12;
    using Three = std::array<double, 3>;
    const Three at_s{a[kS] - centre.s, b[kS] - centre.s, c[kS] - centre.s};
    const Three at_t{a[kT] - centre.t, b[kT] - centre.t, c[kT] - centre.t};
    const double sum_s = (at_s[0] + at_s[1]) + at_s[2], sum_t = (at_t[0] + at_t[1]) + at_t[2];
    const auto product = [](const Three& x, const Three& y) { return (x[0] * y[0] + x[1] * y[1]) + x[2] * y[2]; };
    s += third * sum_s;
    t += third * sum_t;
    ss += twelfth * (sum_s * sum_s + product(at_s, at_s));
    st += twelfth * (sum_s * sum_t + product(at_s, at_t));
    tt += twelfth * (sum_t * sum_t + product(at_t, at_t));
  }
};

/// The corner p0 where that is not known.
Centre centre_of_pressure(const Moments& m) {
  const Centre centre{m.s_depth / m.depth, m.t_depth / m.depth};
  return std::isfinite(centre.s + centre.t) ? centre : Centre{0, 0};
}

class PartSlopes {
 public:
  PartSlopes(const SeenPart& part, PartMotionScratch& scratch)
      : part_(part),
        scratch_(scratch),
        depth_f_(depth_of(part.f)),
        centre_(centre_of_pressure(part.moments)),
        centre_arm_Me_((part.prism.p0_Me() - part.posed.placement.r_Me) +
                       (centre_.s * part.prism.edge_s_Me() + centre_.t * part.prism.edge_t_Me())),
        may_have_edge_on_border_(may_have_edge_on_border(part.f)) {
    add_inside();
    scratch.cuts.clear();
    scratch.open.clear();
    scratch.beyond.start();
    for (const ConvexPolygon& piece : part.pieces) {
      for (int i = 0; i < piece.count; ++i) {
        const SideLine line = piece.lines[static_cast<std::size_t>(i)];
        if (line != kNoLine) {
          add_side(line, piece[i], piece[piece.next(i)]);
        } else if (may_have_edge_on_border_) {
          add_own_side(piece[i], piece[piece.next(i)]);
        }
      }
    }
    add_open_borders();
    if (scratch.cuts.empty()) return;
    scratch.cuts.find_with_one_piece(uncertainty(), scratch.open);
    add_open_borders();
  }

  const IntegralSlopes& sums() const { return sums_; }

 private:
  FaceDepth depth_of(const ProjectedFace& h) const {
    return {part_.posed.face_Me(h.of_master ? part_.master : opposite(part_.master), h.face), part_.prism};
  }

  Uncertainty uncertainty() const {
    return part_.prism.uncertainty(part_.f.corners, part_.posed.placement.max_coordinate);
  }

  /// X - r of the point X at (s, t) from the centre and a depth; `one` times that.
  Vector3d arm_Me(double one, double s, double t, double depth) const {
    const MasterPrism& prism = part_.prism;
    return (one * centre_arm_Me_ + s * prism.edge_s_Me()) + (t * prism.edge_t_Me() - depth * prism.face().n_Me);
  }

  /// What lies at that depth exactly counts as clamped: its depth has slope 0.
  bool any_clamped() const { return part_.moments.greatest >= part_.most; }
  double above_clamp(const PrismPoint& at) const { return part_.most - at[kDepth]; }

  /// Where the depth is not clamped it grows as f moves.
  void add_inside() {
    Moments m;
    PlaceMoments p{centre_};
    if (any_clamped()) {
      for (const ConvexPolygon& piece : part_.pieces) add_shallow(piece, m, p);
    } else {
      m = part_.moments;
      for (const ConvexPolygon& piece : part_.pieces) p.add(piece);
    }
    add_inside(kDepths, m.area, arm_Me(m.area, p.s, p.t, m.depth));
    add_inside(kSDepths, p.s, arm_Me(p.s, p.ss, p.st, m.s_depth - centre_.s * m.depth));
    add_inside(kTDepths, p.t, arm_Me(p.t, p.st, p.tt, m.t_depth - centre_.t * m.depth));
  }
  void add_inside(Integral integral, double weight, const Vector3d& weighted_arm_Me) {
    const Vector3d& g = depth_f_.by_motion_Me;
    sums_[integral].by_position += weight * g;
    sums_[integral].by_rotation += weighted_arm_Me.cross(g);
  }

  void add_shallow(const ConvexPolygon& piece, Moments& moments, PlaceMoments& places) const {
    Heights above{};
    bool any_above = false;
    for (int i = 0; i < piece.count; ++i) {
      above[static_cast<std::size_t>(i)] = above_clamp(piece[i]);
      any_above = any_above || above_clamp(piece[i]) > 0;
    }
    if (!any_above) return;
    ConvexPolygon shallow = piece;
    keep_where_not_negative(shallow, above);
    moments.add(shallow);
    places.add(shallow);
  }

  /// The face and which of its lines.
  std::pair<const ProjectedFace&, int> owner_of(SideLine line) const {
    return {part_.faces[static_cast<std::size_t>((line - 1) / kLinesOfAFace)], (line - 1) % kLinesOfAFace};
  }

  /// A piece's side. Where an edge of another face hides nothing, pieces were cut from each other along its line; where
  /// it only just does, another line may be there.
  void add_side(SideLine line, const PrismPoint& a, const PrismPoint& b) {
    const auto [h, kind] = owner_of(line);
    if (kind >= 3 || &h == &part_.f) {
      if (kind < 3 && hidden_neighbour(part_, static_cast<std::size_t>(kind)) != nullptr && !lies_on_border(a, b)) {
        scratch_.open.push_back({line, a, b});
      } else {
        add_border(line, a, b);
      }
      return;
    }
    const SeenEdge edge(h, static_cast<std::size_t>(kind));
    const double place_a = edge.place(a), place_b = edge.place(b);
    const SeenEdge::Standing standing = edge.standing(a, place_a, b, place_b);
    const double per_share = place_b - place_a;
    const bool is_placed = std::isfinite(per_share) && per_share != 0;
    if (standing == SeenEdge::Standing::before || !is_placed) {
      add_border(line, a, b);
      return;
    }
    if (standing == SeenEdge::Standing::level) {
      add_cut({line, a, b}, place_a, place_b);
      return;
    }
    const Places hides = edge.before(a, b);
    // As shares of the side.
    const double at_first = (hides.first - place_a) / (place_b - place_a);
    const double at_last = (hides.last - place_a) / (place_b - place_a);
    const double from = std::clamp(std::min(at_first, at_last), 0.0, 1.0);
    const double to = hides.first < hides.last ? std::clamp(std::max(at_first, at_last), 0.0, 1.0) : from;
    const PrismPoint way = b - a, at_from = a + from * way, at_to = a + to * way;
    const double from_place = place_a + from * per_share, to_place = place_a + to * per_share;
    if (from > 0) add_cut({line, a, at_from}, place_a, from_place);
    if (from < to) add_border(line, at_from, at_to);
    if (to < 1) add_cut({line, at_to, b}, to_place, place_b);
  }

  /// At these places of the edge, as its face has it.
  void add_cut(const CutStretch& stretch, double place_a, double place_b) {
    const auto [h, kind] = owner_of(stretch.line);
    const auto edge = static_cast<std::size_t>(kind);
    const Index from = h.vertices[edge], to = h.vertices[(edge + 1) % 3];
    if (from < to) {
      scratch_.cuts.add({h.of_master, from, to}, stretch, place_a, place_b);
    } else {
      scratch_.cuts.add({h.of_master, to, from}, stretch, 1 - place_a, 1 - place_b);
    }
  }

  /// Of edges of f, and of cuts, beyond which something else hides f's sheet. Where it can't be told what, they move as
  /// edges and cuts do.
  void add_open_borders() {
    std::vector<CutStretch>& open = scratch_.open;
    if (open.empty()) return;
    const Uncertainty of_f = uncertainty();
    // Each line of each face takes its part of a stretch once; no more is asked, whatever roundings leave.
    std::size_t questions = open.size() * (1 + kLinesOfAFace * part_.faces.size());
    while (!open.empty()) {
      const auto [cut, a, b] = open.back();
      open.pop_back();
      if (lies_on_border(a, b)) {
        add_own_side(a, b);
        continue;
      }
      const bool ask = questions > 0 && are_apart(a, b, of_f);
      const auto found = ask ? find_hiding_line(part_, a, b, scratch_.beyond) : std::nullopt;
      if (!found) {
        add_border(cut, a, b);
        continue;
      }
      --questions;
      const PrismPoint way = b - a, first = a + found->from * way, last = a + found->to * way;
      add_border(found->line, first, last, *found->hidden);
      if (found->from > 0) open.push_back({cut, a, first});
      if (found->to < 1) open.push_back({cut, last, b});
    }
  }

  void add_border(SideLine line, const PrismPoint& a, const PrismPoint& b) { add_border(line, a, b, part_.f); }

  /// Where h hides a face of f's sheet, or passes through it.
  void add_border(SideLine line, const PrismPoint& a, const PrismPoint& b, const ProjectedFace& hidden) {
    const auto [h, kind] = owner_of(line);
    const MasterPrism& prism = part_.prism;
    if (kind == kCrossing && h.of_master) {
      const FaceDepth depth_h = depth_of(h), depth_g = &hidden == &part_.f ? depth_f_ : depth_of(hidden);
      const double l = along_level(a, b, depth_h.per_s - depth_g.per_s, depth_h.per_t - depth_g.per_t);
      add_parts(l * depth_g.by_motion_Me, a, a[kDepth], b, b[kDepth]);
    } else if (h.of_master) {
      return;
    } else if (kind == kAtDepth0) {
      const FaceDepth depth_h = &h == &part_.f ? depth_f_ : depth_of(h);
      add_parts(-along_level(a, b, depth_h.per_s, depth_h.per_t) * depth_h.by_motion_Me, a, 0, b, 0);
    } else {
      if (&h == &part_.f && kind != kCrossing && may_have_edge_on_border_ && lies_beside_border(a, b) &&
          goes_on_unseen(static_cast<std::size_t>(kind)))
        return;
      const Vector3d V = (b[kT] - a[kT]) * prism.inward_Me(2) - (b[kS] - a[kS]) * prism.inward_Me(0);
      if (kind == kCrossing || &h == &part_.f) {
        add_parts(V, a, a[kDepth], b, b[kDepth]);
      } else {
        add_edge(V, SeenEdge(h, static_cast<std::size_t>(kind)), a, b);
      }
    }
  }

  /// Whether the lines leave the slave through that face, too, if they meet it, and it surely has area for them.
  bool goes_on(Index beyond) const {
    if (beyond == part_.f.face) return false;
    const MasterPrism& prism = part_.prism;
    const std::array<PrismPoint, 3> corners =
        prism.see(part_.posed.face_Me(opposite(part_.master), beyond), part_.posed.work);
    // Seen from within, it runs the other way about.
    const double area = -0.5 * cross_st(corners[0], corners[1], corners[2]);
    const PrismPoint low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
    const PrismPoint high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
    return certain(area, high[kS] - low[kS], high[kT] - low[kT],
                   prism.uncertainty(corners, part_.posed.placement.max_coordinate));
  }

  /// The side of the master on which a part's side lies, to within roundings.
  std::optional<std::size_t> side_of_master(const PrismPoint& a, const PrismPoint& b) const {
    const MasterPrism& prism = part_.prism;
    for (int weight = 0; weight < 3; ++weight) {
      const std::size_t side = static_cast<std::size_t>(weight + 1) % 3;
      if (std::abs(a[weight]) <= prism.weight_error(side, a) && std::abs(b[weight]) <= prism.weight_error(side, b))
        return side;
    }
    return std::nullopt;
  }
  bool lies_on_border(const PrismPoint& a, const PrismPoint& b) const { return side_of_master(a, b).has_value(); }

  /// Whether nothing of a face beyond an edge is in the master's view, though the sheet goes on there.
  bool goes_on_unseen(std::size_t edge) const {
    const Index face = face_beyond(part_, edge);
    return carrying_face(part_, face) == nullptr && goes_on(face);
  }

  /// How far a line may be from another one where a face in between has no area for certain, as one of the master's
  /// faces sees it or as its neighbour does.
  static Uncertainty beside(const Uncertainty& of_f) { return {4 * of_f.s, 4 * of_f.t}; }

  bool lies_beside_border(const PrismPoint& a, const PrismPoint& b) const {
    const Uncertainty near = beside(uncertainty());
    for (int k = 0; k < 3; ++k)
      if (lie_on_line(a, b, MasterPrism::corner(k), MasterPrism::corner((k + 1) % 3), near)) return true;
    return false;
  }

  /// A side on the border of the master. Where the sheet that f is of ends there as well, to within roundings, or
  /// beyond, but the master's next face sees so little of f that this counts as nothing, it moves as the edge does:
  /// what is seen between the two, which may be less than nothing, is for both.
  void add_own_side(const PrismPoint& a, const PrismPoint& b) {
    const std::optional<std::size_t> side = side_of_master(a, b);
    if (!side) return;  // but parts two pieces
    const Uncertainty of_f = uncertainty(), near = beside(of_f);
    for (std::size_t edge = 0; edge < 3; ++edge) {
      const PrismPoint &from = part_.f.corners[edge], &to = part_.f.corners[(edge + 1) % 3];
      if (!lie_on_line(a, b, from, to, near) || goes_on(face_beyond(part_, edge))) continue;
      const SeenArea beyond = seen_beyond(*side);
      if (beyond == SeenArea::uncertain || (beyond == SeenArea::none && lie_on_line(a, b, from, to, of_f)))
        add_border(line_of_face(part_.f.number, static_cast<int>(edge)), a, b);
      return;
    }
  }

  /// What of f the master's face sees that lies beyond one of its sides.
  SeenArea seen_beyond(std::size_t side) const {
    const Index beyond = part_.posed.surface(part_.master).neighbours_of(part_.master_face)[side];
    if (beyond == part_.master_face) return SeenArea::none;
    const FaceGeometry geometry = face_with_sure_normal(part_.posed.face_Me(part_.master, beyond));
    if (!(geometry.area > 0)) return SeenArea::none;
    return seen_area(part_.posed, part_.master, MasterPrism(geometry), part_.f.face);
  }

  /// A side on the line of an edge.
  void add_edge(const Vector3d& V, const SeenEdge& edge, const PrismPoint& a, const PrismPoint& b) {
    const double place_a = edge.place(a), place_b = edge.place(b);
    double from = 0;
    PrismPoint start = a;
    double depth = edge.depth(place_a);
    const auto add_until = [&](double share, const PrismPoint& end, double depth_there) {
      add_parts((share - from) * V, start, depth, end, depth_there);
      from = share;
      start = end;
      depth = depth_there;
    };
    std::array<double, 2> knots{SeenEdge::kFirst, SeenEdge::kLast};
    if (place_b < place_a) std::swap(knots[0], knots[1]);
    for (const double knot : knots) {
      if ((place_a < knot) == (place_b < knot)) continue;
      const double share = (knot - place_a) / (place_b - place_a);
      if (share > 0 && share < 1) add_until(share, a + share * (b - a), edge.depth(knot));
    }
    add_until(1, b, edge.depth(place_b));
  }

  /// A side that moves by V . d(X), X at depths below a and b that may not be f's: in two parts where f's is clamped on
  /// one of them.
  void add_parts(const Vector3d& V, const PrismPoint& a, double depth_a, const PrismPoint& b, double depth_b) {
    if (!(V.allFinite() && std::isfinite(depth_a) && std::isfinite(depth_b))) return;
    const double above_a = above_clamp(a), above_b = above_clamp(b);
    if (!(std::min(above_a, above_b) < 0 && std::max(above_a, above_b) > 0)) {
      add_part(V, a, depth_a, b, depth_b);
      return;
    }
    const double share = above_a / (above_a - above_b);
    const PrismPoint between = a + share * (b - a);
    const double depth = depth_a + share * (depth_b - depth_a);
    add_part(share * V, a, depth_a, between, depth);
    add_part((1 - share) * V, between, depth, b, depth_b);
  }

  /// At (s, t) from the centre.
  Integrands integrands(double s, double t, double depth) const {
    const double clamped = std::min(depth, part_.most);
    return {1, clamped, s * clamped, t * clamped};
  }

  /// By Simpson's rule, exact for products of three linear functions.
  void add_part(const Vector3d& V, const PrismPoint& a, double depth_a, const PrismPoint& b, double depth_b) {
    const double a_s = a[kS] - centre_.s, a_t = a[kT] - centre_.t, b_s = b[kS] - centre_.s, b_t = b[kT] - centre_.t;
    const Integrands at_a = integrands(a_s, a_t, a[kDepth]), at_b = integrands(b_s, b_t, b[kDepth]);
    const Integrands between = integrands(0.5 * (a_s + b_s), 0.5 * (a_t + b_t), 0.5 * (a[kDepth] + b[kDepth]));
    const Vector3d V_6 = V / 6;
    const Vector3d moment_a = arm_Me(1, a_s, a_t, depth_a).cross(V_6);
    const Vector3d moment_b = arm_Me(1, b_s, b_t, depth_b).cross(V_6);
    for (std::size_t i = 0; i < kIntegrals; ++i) {
      const double weight_a = at_a[i] + 2 * between[i], weight_b = at_b[i] + 2 * between[i];
      sums_[i].by_position += (weight_a + weight_b) * V_6;
      sums_[i].by_rotation += weight_a * moment_a + weight_b * moment_b;
    }
  }

  const SeenPart& part_;
  PartMotionScratch& scratch_;
  FaceDepth depth_f_;
  Centre centre_;
  Vector3d centre_arm_Me_;  ///< X - r at the centre, in the master's plane
  bool may_have_edge_on_border_;
  IntegralSlopes sums_;
};

}  // namespace

ElementMotion motion_of_part(const SeenPart& part, PartMotionScratch& scratch) {
  const PartSlopes slopes(part, scratch);
  const IntegralSlopes& by = slopes.sums();
  const Moments& m = part.moments;
  const double twice_area = 2 * part.prism.face().area;
  ElementMotion motion;
  motion.area = {twice_area * by[kOne].by_position, twice_area * by[kOne].by_rotation};
  motion.depth = of_quotient(by[kDepths], m.area, by[kOne], m.depth / m.area);
  motion.s = {by[kSDepths].by_position / m.depth, by[kSDepths].by_rotation / m.depth};
  motion.t = {by[kTDepths].by_position / m.depth, by[kTDepths].by_rotation / m.depth};
  for (MotionSlope* const slope : {&motion.area, &motion.depth, &motion.s, &motion.t})
    if (!is_finite(*slope)) *slope = {};
  motion.edge_s_Me = part.prism.edge_s_Me();
  motion.edge_t_Me = part.prism.edge_t_Me();
  return motion;
}

}  // namespace pcm::fast
