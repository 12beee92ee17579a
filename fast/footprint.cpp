// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fast/prism_error.h"
#include "fast/vertex_rounding.h"

namespace pcm::fast {

namespace {

constexpr double u = kUnitRoundoff;
/// A cut puts a new vertex off the line through its neighbours, and off the cutting line where that is a line of zeros
/// of a coordinate, by 4 u times the way from the nearer neighbour and u times itself: no more than 3 u and 5 u times
/// the corners' greatest |coordinate|. Vertices between those that are off are off by no more than these and their own.
constexpr double kOffPlane = 3;
constexpr double kOffCut = 5;
/// A cut by a side: twice two differences, two products, a sum, and one to spare.
constexpr double kSideRoundings = 5;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double greatest_of(const std::array<PrismPoint, 3>& corners, int coordinate) {
  return std::max(
      {std::abs(corners[0][coordinate]), std::abs(corners[1][coordinate]), std::abs(corners[2][coordinate])});
}

double least_of(const std::array<PrismPoint, 3>& corners, int coordinate) {
  return std::min({corners[0][coordinate], corners[1][coordinate], corners[2][coordinate]});
}

/// Whether a neighbour of the master face, which shares corners with it, surely lies beside it.
bool surely_beside(const std::array<PrismPoint, 3>& corners, const std::array<bool, 3>& shared, double s, double t) {
  const std::array<double, 3> margin{s + t, s, t};
  for (int weight = 0; weight < 3; ++weight) {
    bool beside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double w = corners[k][weight];
      beside = beside && (shared[k] ? w == 0 : w < -margin[static_cast<std::size_t>(weight)]);
    }
    if (beside) return true;
  }
  return false;
}

/// Whether all corners lie beyond one of the master's sides, by more than a shift of (s, t), or above its plane.
bool surely_outside(const std::array<PrismPoint, 3>& corners, const PrismShift& shift) {
  const auto all_below = [&corners](int coordinate, double level) {
    return corners[0][coordinate] < level && corners[1][coordinate] < level && corners[2][coordinate] < level;
  };
  return all_below(0, -(shift.s + shift.t)) || all_below(kS, -shift.s) || all_below(kT, -shift.t) ||
         all_below(kDepth, -shift.depth);
}

PrismShift sum_of(const PrismShift& a, const PrismShift& b) {
  return {a.s + b.s, a.t + b.t, a.depth + b.depth};
}

/// Points a + lambda way of the plane, lambda from `low` to `high`.
struct Stretch {
  double s, t, way_s, way_t;
  double low = 0, high = 1;

  double s_at(double lambda) const { return s + lambda * way_s; }
  double t_at(double lambda) const { return t + lambda * way_t; }
  double length() const { return std::max(high - low, 0.0); }
  bool empty() const { return !(low <= high); }
  /// Keeps where value + lambda rate >= 0.
  void keep(double value, double rate) {
    if (rate > 0) {
      low = std::max(low, -value / rate);
    } else if (rate < 0) {
      high = std::min(high, value / -rate);
    } else if (value < 0) {
      high = -kInfinity;
    }
  }
  /// Keeps what is within (s, t) of the box and of the master's third side.
  void keep_in(const BoxST& box, double margin_s, double margin_t) {
    keep(s - (box.low_s - margin_s), way_s);
    keep((box.high_s + margin_s) - s, -way_s);
    keep(t - (box.low_t - margin_t), way_t);
    keep((box.high_t + margin_t) - t, -way_t);
    keep((1 + margin_s + margin_t) - s - t, -way_s - way_t);
  }
  /// Keeps what is within (s, t) of a face however its sides are shifted.
  void keep_in(const Footprint& face, double margin_s, double margin_t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const PrismPoint& a = face.corners[k];
      const PrismPoint& b = face.corners[(k + 1) % 3];
      const double side_s = b[kS] - a[kS], side_t = b[kT] - a[kT];
      const double margin = 2 * face.side_shift[k] + std::abs(side_s) * margin_t + std::abs(side_t) * margin_s;
      keep(side_s * (t - a[kT]) - side_t * (s - a[kS]) + margin, side_s * way_t - side_t * way_s);
    }
  }
  /// No depth of a face is greater within (s, t) of it.
  double greatest_depth(const Footprint& face, double margin_s, double margin_t) const {
    if (face.facing == 0) return std::max(face.greatest, 0.0);
    const double depth = std::max(face.depth.at(s_at(low), t_at(low)), face.depth.at(s_at(high), t_at(high)));
    const double margin =
        face.depth_error + std::abs(face.depth.per_s) * margin_s + std::abs(face.depth.per_t) * margin_t;
    return std::clamp(depth + margin, 0.0, std::max(face.greatest, 0.0));
  }
};

/// The part of a face that may come to lie over the master face, at a depth >= 0, when its points are shifted; all
/// coordinates are larger by the shift.
ConvexPolygon part_over_master(const std::array<PrismPoint, 3>& corners, const PrismShift& shift) {
  ConvexPolygon part;
  const PrismPoint enlarged(shift.s + shift.t, shift.s, shift.t, shift.depth);
  for (const PrismPoint& corner : corners) part.add(corner + enlarged);
  for (int coordinate = 0; coordinate <= kDepth; ++coordinate) {
    if (least_of(corners, coordinate) >= 0) continue;
    keep_where_not_negative(part, coordinate);
    if (part.count == 0) break;
  }
  return part;
}

BoxST box_of(const PrismPoint* points, int count) {
  BoxST box{points[0][kS], points[0][kS], points[0][kT], points[0][kT]};
  for (int i = 1; i < count; ++i) {
    const PrismPoint& x = points[i];
    box.low_s = std::min(box.low_s, x[kS]);
    box.high_s = std::max(box.high_s, x[kS]);
    box.low_t = std::min(box.low_t, x[kT]);
    box.high_t = std::max(box.high_t, x[kT]);
  }
  return box;
}

/// Whether a side of a has b on its far side when both faces are shifted: certainly, or but for what the shifts make.
struct Separation {
  enum class Kind : std::uint8_t { none, near, certain } found = Kind::none;
  LinearDepth side;   ///< the linear function that is 0 along the side
  double margin = 0;  ///< how far the shifts may move it
};

void separate(const Footprint& a, const Footprint& b, double shift_s, double shift_t, Separation& best) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const PrismPoint& from = a.corners[k];
    const double side_s = a.corners[next][kS] - from[kS], side_t = a.corners[next][kT] - from[kT];
    double certainty = kInfinity, greatest_margin = 0;
    for (std::size_t j = 0; j < 3 && certainty > -1; ++j) {
      if (a.own == b.own && (b.vertices[j] == a.vertices[k] || b.vertices[j] == a.vertices[next])) continue;
      const double to_s = b.corners[j][kS] - from[kS], to_t = b.corners[j][kT] - from[kT];
      // The shifts pay for the roundings as well.
      const double margin = 2 * shift_s * (std::abs(side_t) + std::abs(to_t) + 4 * shift_t) +
                            2 * shift_t * (std::abs(side_s) + std::abs(to_s));
      const double below = side_t * to_s - side_s * to_t;
      greatest_margin = std::max(greatest_margin, margin);
      certainty = std::min(certainty, below > margin ? 1.0 : below >= -margin ? 0.0 : -1.0);
    }
    if (certainty > 0) {
      best.found = Separation::Kind::certain;
      return;
    }
    if (certainty == 0 && best.found == Separation::Kind::none) {
      best = {Separation::Kind::near, {0, from[kS], from[kT], -side_t, side_s}, greatest_margin};
    }
  }
}

/// Two faces that look the same way, both surely, lie on either side of the side they share.
bool share_a_side(const Footprint& a, const Footprint& b) {
  if (a.own != b.own || a.facing == 0 || a.facing != b.facing) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (a.vertices[k] == b.vertices[(j + 1) % 3] && a.vertices[(k + 1) % 3] == b.vertices[j]) return true;
    }
  }
  return false;
}

/// On which side of the plane of f the vertices of g certainly lie: 1 all above, -1 all below, 0 unsure. With lambda
/// the barycentric coordinates of a vertex c of g in f, both as shifted, the plane of f passes there within sum
/// |lambda| (depth + gradient x shift of f's vertices) of the unshifted one.
int certain_side(const Footprint& f, const Footprint& g) {
  const auto steepness = [&f](const PrismShift& shift) {
    return shift.depth + std::abs(f.depth.per_s) * shift.s + std::abs(f.depth.per_t) * shift.t;
  };
  const double of_plane = steepness(f.vertex_shift), of_vertex = steepness(g.vertex_shift);
  const double twice_area = cross_st(f.corners[0], f.corners[1], f.corners[2]);
  int above = 0, below = 0, shared = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    if (f.own == g.own && std::find(f.vertices.begin(), f.vertices.end(), g.vertices[j]) != f.vertices.end()) {
      ++shared;
      continue;
    }
    const PrismPoint& c = g.corners[j];
    double lambda = 0, widths = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const PrismPoint& a = f.corners[k];
      lambda += std::abs(cross_st(a, f.corners[(k + 1) % 3], c));
      widths += (f.corner_shift.s + g.corner_shift.s) * (std::abs(c[kT] - a[kT]) + g.corner_shift.t) +
                (f.corner_shift.t + g.corner_shift.t) * std::abs(c[kS] - a[kS]);
    }
    // Shifting leaves the face at least half its area (find_footprint).
    lambda = 2 * (lambda + 8 * widths) / twice_area;
    const double plane =
        f.depth.value + (f.depth.per_s * (c[kS] - f.depth.s_0) + f.depth.per_t * (c[kT] - f.depth.t_0));
    const double error =
        2 * (of_plane * lambda + of_vertex) + f.relative_noise * (std::abs(plane) + std::abs(c[kDepth]));
    above += plane - c[kDepth] > error ? 1 : 0;
    below += plane - c[kDepth] < -error ? 1 : 0;
  }
  if (shared == 3) return 0;
  return above + shared == 3 ? 1 : below + shared == 3 ? -1 : 0;
}

}  // namespace

CertainOrder certain_order(const Footprint& g, const Footprint& f) {
  const int g_over_f = certain_side(f, g);
  const int f_over_g = g_over_f == 0 ? certain_side(g, f) : 0;
  if (g_over_f > 0 || f_over_g < 0) return CertainOrder::before;
  return g_over_f < 0 || f_over_g > 0 ? CertainOrder::after : CertainOrder::unsure;
}

BoxST BoxST::common(const BoxST& other) const {
  return {std::max(low_s, other.low_s), std::min(high_s, other.high_s), std::max(low_t, other.low_t),
          std::min(high_t, other.high_t)};
}

bool surely_unseen(const PrismError& error, bool own, const std::array<PrismPoint, 3>& corners) {
  const double distance =
      error.distance(greatest_of(corners, kS), greatest_of(corners, kT), greatest_of(corners, kDepth));
  const double deepest = std::max({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth], 0.0});
  return surely_outside(corners,
                        sum_of(error.of_any_vertices(error.greatest_noise(distance), own), error.of_frame(deepest)));
}

// The two steps of PrismError move each corner by no more than corner_shift but for an affine map of the plane, which
// leaves windings and sides as they are; and each point that is seen by no more than `shift`, its depth besides by
// shift.depth. A depth at a fixed (s, t) is off by what depth - per_s s - per_t t is, a side by its cross product with
// the displacement. Windings: with both edges shifted by up to twice corner_shift the product changes by at most
// 4 (s width_t + t width_s + 2 s t).
bool find_footprint(const PrismError& error, Index face, bool own, const std::array<Index, 3>& vertices,
                    const std::array<PrismPoint, 3>& corners, const std::array<bool, 3>& shared,
                    const Eigen::Vector3d& rounding_Me, double twice_area_of_master, Footprint& f) {
  const double greatest_s = greatest_of(corners, kS), greatest_t = greatest_of(corners, kT);
  const double farthest_depth = greatest_of(corners, kDepth);
  const double distance = error.distance(greatest_s, greatest_t, farthest_depth);
  const double deepest = std::max({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth]});
  const PrismShift widest_frame = error.of_frame(std::max(deepest, 0.0));
  const PrismShift noise = error.noise(corners);
  const PrismShift of_vertices = error.of_vertices(noise, rounding_Me);
  const PrismShift of_tilt = error.of_tilt(farthest_depth);
  f.vertex_shift = of_vertices;
  f.corner_shift = {of_vertices.s + of_tilt.s, of_vertices.t + of_tilt.t, 0};
  f.hinge_depth = 0;
  if (shared[0] || shared[1] || shared[2]) {
    const PrismShift frame = error.of_frame(farthest_depth);
    const double far = 1 + greatest_s + greatest_t;
    f.hinge_shift = {of_vertices.s + far * frame.s, of_vertices.t + far * frame.t,
                     of_vertices.depth + far * frame.depth + far * distance * frame.s};
    if (surely_beside(corners, shared, f.hinge_shift.s, f.hinge_shift.t)) return false;
    f.hinge_depth = kInfinity;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!shared[k]) f.hinge_depth = std::min(f.hinge_depth, corners[k][kDepth]);
    }
    f.hinge_depth = std::isfinite(f.hinge_depth) ? std::max(f.hinge_depth - 2 * f.hinge_shift.depth, 0.0) : 0;
  }

  const PrismShift widest = sum_of(of_vertices, widest_frame);
  f.box = box_of(corners.data(), 3);
  f.greatest = deepest + widest.depth;
  if (std::min({least_of(corners, 0), least_of(corners, kS), least_of(corners, kT), least_of(corners, kDepth)}) < 0) {
    const ConvexPolygon part = part_over_master(corners, widest);
    if (part.count == 0) return false;
    f.box = box_of(part.points.data(), part.count);
    f.greatest = part[0][kDepth];
    for (int i = 1; i < part.count; ++i) f.greatest = std::max(f.greatest, part[i][kDepth]);
  }
  // Both ways about what may be enlarged.
  f.box.low_s = std::max(f.box.low_s - 2 * widest.s, 0.0);
  f.box.low_t = std::max(f.box.low_t - 2 * widest.t, 0.0);
  f.box.high_s = std::min(f.box.high_s + widest.s, 1.0);
  f.box.high_t = std::min(f.box.high_t + widest.t, 1.0);
  if (f.box.empty()) return false;
  const PrismShift frame = error.of_frame(f.greatest);
  f.shift = sum_of(of_vertices, frame);
  f.cuts = 0;
  for (int coordinate = 0; coordinate < kDepth; ++coordinate) f.cuts += least_of(corners, coordinate) <= 0 ? 1 : 0;
  const int side_cuts = f.cuts;
  f.cuts += least_of(corners, kDepth) <= 0 ? 1 : 0;
  f.cut_shift = {kOffCut * u * f.cuts * greatest_s, kOffCut * u * f.cuts * greatest_t, 0};
  f.third_side_shift = error.of_third_weight(f.greatest, noise);

  f.face = face;
  f.own = own;
  f.rounding_Me = rounding_Me;
  f.vertices = vertices;
  f.corners = corners;
  f.noise = noise;
  f.knows_sides = false;
  f.fixed = shared;
  const double twice_area = cross_st(corners[0], corners[1], corners[2]);
  if (twice_area < 0) {
    std::swap(f.vertices[1], f.vertices[2]);
    std::swap(f.corners[1], f.corners[2]);
    std::swap(f.fixed[1], f.fixed[2]);
  }
  const PrismPoint a = f.corners[1] - f.corners[0], b = f.corners[2] - f.corners[0];
  const double width_s = std::abs(a[kS]) + std::abs(b[kS]), width_t = std::abs(a[kT]) + std::abs(b[kT]);
  const double turn =
      4 * (f.corner_shift.s * width_t + f.corner_shift.t * width_s + 2 * f.corner_shift.s * f.corner_shift.t);
  f.greatest += f.shift.depth;
  if (!(std::abs(twice_area) > 2 * turn)) {
    f.facing = 0;
    f.sliver = 0.5 * std::abs(twice_area);
    f.depth = {0, 0, 0};
    f.field_error = f.line_error = f.depth_error = kInfinity;
    f.cut_noise = f.relative_noise = f.crossing_noise = 0;
    return f.greatest >= 0;
  }
  f.facing = twice_area < 0 ? -1 : 1;
  f.sliver = 0;
  const double inverse = 1 / std::abs(twice_area);
  f.depth = {f.corners[0][kDepth], f.corners[0][kS], f.corners[0][kT],
             (a[kDepth] * b[kT] - b[kDepth] * a[kT]) * inverse, (b[kDepth] * a[kS] - a[kDepth] * b[kS]) * inverse};
  f.relative_noise = 16 * u * width_s * width_t * inverse;
  f.cut_noise =
      kOffPlane * u * (farthest_depth + std::abs(f.depth.per_s) * greatest_s + std::abs(f.depth.per_t) * greatest_t);
  // At depth 0 it is cut last: what is left then lies over the master.
  const double slopes = std::abs(f.depth.per_s) + std::abs(f.depth.per_t);
  const double last_cut = std::min(f.cut_noise, kOffPlane * u * (std::abs(f.depth.at(0, 0)) + 2 * slopes));
  f.field_error =
      kBoundMargin * error.of_function({-f.depth.per_s, -f.depth.per_t, 1}, f.greatest, noise, rounding_Me) +
      side_cuts * f.cut_noise + (f.cuts - side_cuts) * last_cut;
  f.line_error = f.field_error + 2 * last_cut;
  f.depth_error = f.line_error + f.relative_noise * farthest_depth;
  f.greatest = std::min(f.greatest, f.depth.middle(f.box) + f.depth.reach(f.box)) + f.depth_error;
  const auto length_of = [&error](const PrismPoint& edge) {
    return error.distance(std::abs(edge[kS]), std::abs(edge[kT]), std::abs(edge[kDepth]));
  };
  f.crossing_noise = 16 * u * length_of(a) * length_of(b) * inverse / twice_area_of_master;
  return f.greatest >= 0;
}

void find_side_shifts(const PrismError& error, Footprint& f) {
  if (f.knows_sides) return;
  f.knows_sides = true;
  const double greatest_s = greatest_of(f.corners, kS), greatest_t = greatest_of(f.corners, kT);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const PrismPoint& a = f.corners[k];
    const PrismPoint& b = f.corners[next];
    const double side_s = b[kS] - a[kS], side_t = b[kT] - a[kT];
    // Either end may be the one that a cut is reckoned from.
    const double from_s = std::max({std::abs(f.box.low_s - a[kS]), std::abs(f.box.high_s - a[kS]),
                                    std::abs(f.box.low_s - b[kS]), std::abs(f.box.high_s - b[kS])});
    const double from_t = std::max({std::abs(f.box.low_t - a[kT]), std::abs(f.box.high_t - a[kT]),
                                    std::abs(f.box.low_t - b[kT]), std::abs(f.box.high_t - b[kT])});
    f.side_shift[k] = kSideRoundings * u * (std::abs(side_t) * from_s + std::abs(side_s) * from_t);
    f.side_cuts[k] = kOffPlane * u * f.cuts * (std::abs(side_t) * greatest_s + std::abs(side_s) * greatest_t);
    // Corners that are the master's are where they are in both problems.
    if (!(f.fixed[k] && f.fixed[next])) {
      f.side_shift[k] += error.of_function({-side_t, side_s, 0}, f.greatest, f.noise, f.rounding_Me);
    }
  }
}

double greatest_overlap(const Footprint& a, const Footprint& b, const BoxST& box) {
  if (share_a_side(a, b)) return 0;
  const double s = std::max(a.corner_shift.s, b.corner_shift.s), t = std::max(a.corner_shift.t, b.corner_shift.t);
  Separation separation;
  separate(a, b, s, t, separation);
  if (separation.found != Separation::Kind::certain) separate(b, a, s, t, separation);
  if (separation.found == Separation::Kind::certain) return 0;
  if (separation.found == Separation::Kind::none) return box.area();
  const double margin = 3 * separation.margin;
  return std::min(box.area(), 2 * zero_strip(separation.side, {margin, margin}, box).area);
}

// That of all that shifts may bring over the master, and what its border may pass over then.
double greatest_area(const Footprint& face) {
  const ConvexPolygon part = part_over_master(face.corners, face.shift);
  return std::min(face.box.area(),
                  (1 + 0x1p-40) * (0.5 * std::abs(twice_area(part))) +
                      strip_along_border(face.box, face.shift.s + face.cut_shift.s, face.shift.t + face.cut_shift.t));
}

// Its computed area, and what its sides may pass over.
SideStrips sliver(const Footprint& face, const Footprint& carrier, double depth, const BoxST& box) {
  PrismShift shift = face.shift;
  double area = face.sliver;
  if (depth < 0.5 * face.hinge_depth) {
    const double share = kBoundMargin * depth / face.hinge_depth;
    area *= 2 * share;
    shift = {std::min(shift.s, share * face.hinge_shift.s), std::min(shift.t, share * face.hinge_shift.t), 0};
  }
  SideStrips all = strips_along_sides(face, shift.s, shift.t, carrier, box);
  all.area = std::min(area + all.area, box.area());
  all.volume = std::min(area * depth + all.volume, all.area * depth);
  return all;
}

// What a side passes over lies between where it is and where it was, and within (s, t) of it: in the coordinates lambda
// along the side and (side) x (x - a) across it, whose determinant is 1, that is no more than side_shift by the
// stretch of the side that is within (s, t) of the box. Twice these margins pay for roundings.
SideStrips strips_along_sides(const Footprint& face, double s, double t, const Footprint& carrier, const BoxST& box,
                              const std::array<bool, 3>& sides) {
  const double middle_s = 0.5 * (box.low_s + box.high_s), middle_t = 0.5 * (box.low_t + box.high_t);
  SideStrips strips;
  for (std::size_t k = 0; k < 3; ++k) {
    const PrismPoint& a = face.corners[k];
    const PrismPoint& b = face.corners[(k + 1) % 3];
    const double side_s = b[kS] - a[kS], side_t = b[kT] - a[kT];
    const double inward = side_s * (middle_t - a[kT]) - side_t * (middle_s - a[kS]);
    const double reach = std::abs(side_s) * (0.5 * box.width_t() + t) + std::abs(side_t) * (0.5 * box.width_s() + s);
    if (inward < -reach) strips.apart = true;
    if (!sides[k] || std::abs(inward) > reach) continue;
    const double by_shift = std::abs(side_s) * t + std::abs(side_t) * s;
    if (&carrier == &face && !face.knows_sides) {
      // Of the side's extent no more than the box's counts.
      const double extent_s = std::min(std::abs(side_s), box.width_s() + 4 * s);
      const double extent_t = std::min(std::abs(side_t), box.width_t() + 4 * t);
      const double area = kBoundMargin * (extent_s * t + extent_t * s) + 16 * s * t;
      strips.area += area;
      strips.volume += area * face.greatest;
      continue;
    }
    Stretch stretch{a[kS], a[kT], side_s, side_t};
    stretch.keep_in(box, 2 * s, 2 * t);
    if (&carrier != &face && carrier.facing != 0) stretch.keep_in(carrier, 2 * s, 2 * t);
    if (face.facing != 0) {
      const double margin = 2 * (face.depth_error + std::abs(face.depth.per_s) * s + std::abs(face.depth.per_t) * t);
      stretch.keep(a[kDepth] + margin, b[kDepth] - a[kDepth]);
    }
    if (stretch.empty()) continue;
    double beyond = 1;
    if (s < std::abs(side_s)) beyond = s / std::abs(side_s);
    if (t < beyond * std::abs(side_t)) beyond = t / std::abs(side_t);
    double width = by_shift;
    if (face.knows_sides) width = std::min(face.side_shift[k], by_shift) + (&carrier == &face ? face.side_cuts[k] : 0);
    const double area = width * (stretch.length() + 4 * beyond) + 4 * s * t;
    strips.area += area;
    strips.volume += area * stretch.greatest_depth(carrier, 2 * s, 2 * t);
  }
  strips.area = std::min(strips.area, box.area());
  return strips;
}

// Points between the zeros of both functions are no farther from the line where the given one is 0 than either.
LineStrip strip_along_line(const LinearDepth& function, const LineError& error, const Footprint& f, const Footprint& g,
                           const BoxST& box) {
  const double greatest = std::max(f.greatest, 0.0);
  const ZeroStrip strip = zero_strip(function, error, box);
  if (!(strip.area > 0) || strip.everywhere) return {strip.area, strip.area * greatest, strip.everywhere};
  const bool across_s = std::abs(function.per_s) * box.width_s() >= std::abs(function.per_t) * box.width_t();
  const double at_corner = function.at(box.low_s, box.low_t);
  Stretch stretch;
  double away, wide, slope;
  if (across_s) {
    stretch = {box.low_s - at_corner / function.per_s, box.low_t, -function.per_t / function.per_s * box.width_t(),
               box.width_t()};
    slope = std::abs(function.per_s) - 2 * error.off / box.width_s();
    wide = box.width_t();
  } else {
    stretch = {box.low_s, box.low_t - at_corner / function.per_t, box.width_s(),
               -function.per_s / function.per_t * box.width_s()};
    slope = std::abs(function.per_t) - 2 * error.off / box.width_t();
    wide = box.width_s();
  }
  if (!(slope > 0)) return {strip.area, strip.area * greatest, false};
  away = error.off / slope;
  const double s = (across_s ? 2 * away : 0) + 2 * f.shift.s + 2 * g.shift.s;
  const double t = (across_s ? 0 : 2 * away) + 2 * f.shift.t + 2 * g.shift.t;
  stretch.keep_in(box, s, t);
  if (f.facing != 0) stretch.keep_in(f, s, t);
  if (g.facing != 0) stretch.keep_in(g, s, t);
  if (stretch.empty()) return {};
  const double area = std::min(strip.area, error.apart / slope * wide * stretch.length() * kBoundMargin);
  return {area, area * stretch.greatest_depth(f, s, t), false};
}

// Of a side's extent only that share counts along which the function changes by twice the error.
double zero_strip_at_sides(const Footprint& face, const std::array<bool, 3>& sides, const LinearDepth& function,
                           double error, const BoxST& box) {
  const double s = face.shift.s, t = face.shift.t;
  double area = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!sides[k]) continue;
    const PrismPoint side = face.corners[(k + 1) % 3] - face.corners[k];
    const double rise = std::abs(function.per_s * side[kS] + function.per_t * side[kT]);
    const double share = rise > 0 ? 2 * error / rise : kInfinity;
    const double width_s = std::min(box.width_s(), share * std::abs(side[kS]) + 2 * s);
    const double width_t = std::min(box.width_t(), share * std::abs(side[kT]) + 2 * t);
    area += 2 * (width_s * t + width_t * s) + 8 * s * t;
  }
  return std::min(area, box.area());
}

double strip_along_border(const BoxST& box, double s, double t) {
  return std::min(box.area(), 2 * (box.width_s() * t + box.width_t() * s) + 48 * s * t);
}

// At each s, or t, the zeros of both functions are no farther apart than what they differ by over the slope of either;
// over the width of the box that is off by twice what the function is.
ZeroStrip zero_strip(const LinearDepth& function, const LineError& error, const BoxST& box) {
  const double middle = std::abs(function.middle(box)), reach = function.reach(box);
  if (middle - reach > error.off) return {};
  if (middle + reach <= error.off) return {box.area(), true};
  const auto across = [&error](double slope, double width) {
    const double least_rise = std::abs(slope) * width - 2 * error.off;
    return least_rise > error.apart ? width * (kBoundMargin * error.apart / least_rise) : width;
  };
  const double across_s = across(function.per_s, box.width_s()), across_t = across(function.per_t, box.width_t());
  return {std::min(across_s * box.width_t(), across_t * box.width_s()), false};
}

}  // namespace pcm::fast
