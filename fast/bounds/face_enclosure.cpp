// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/face_enclosure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fast/bounds/prism_error.h"
#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

namespace {

constexpr double u = kUnitRoundoff;
/// A cut puts a new vertex off the line through its neighbours by 2 u times the way from the nearer one, at most half
/// of what the corners' coordinates are apart, and u times itself; off the cutting line, where that is a line of zeros
/// of a coordinate, by 4 u times that way and u times itself. Vertices between those that are off are off by no more
/// than these and their own.
double off_line(double apart, double greatest) {
  return u * (apart + greatest);
}
double off_cut(double apart, double greatest) {
  return u * (2 * apart + greatest);
}
/// A linear function given by its values at a face's corners, none greater than H, is computed with no more than 38
/// roundings of H times the product of the face's widths over its doubled area; which may be off by a quarter itself
/// where a face's facing is sure.
constexpr double kLinearRoundings = 52;
/// Its slopes: the rises, the edges, the products, their difference, the quotient and the area, twice for the latter.
constexpr double kSlopeRoundings = 12;
/// The height of a point x over the plane of a face with the edges a and b from f0, by which faces are cut where they
/// meet: a sum of six products of three differences, of which each has 8 roundings, and which add up to no more than
/// sqrt(2) |a| |b| |x - f0|. That makes 12, and 4 for the cut itself.
constexpr double kCrossingRoundings = 16;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double greatest_of(const std::array<PrismPoint, 3>& corners, int coordinate) {
  return std::max(
      {std::abs(corners[0][coordinate]), std::abs(corners[1][coordinate]), std::abs(corners[2][coordinate])});
}

double least_of(const std::array<PrismPoint, 3>& corners, int coordinate) {
  return std::min({corners[0][coordinate], corners[1][coordinate], corners[2][coordinate]});
}

double greatest_difference(const std::array<PrismPoint, 3>& corners, int coordinate) {
  return std::max({corners[0][coordinate], corners[1][coordinate], corners[2][coordinate]}) -
         least_of(corners, coordinate);
}

/// Whether a neighbour of the master face, which shares corners with it, surely lies beside it.
bool surely_beside(const std::array<PrismPoint, 3>& corners, const std::array<bool, 3>& shared,
                   const std::array<double, 3>& weight_error) {
  for (int weight = 0; weight < 3; ++weight) {
    bool beside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const double w = corners[k][weight];
      beside = beside && (shared[k] ? w == 0 : w < -weight_error[static_cast<std::size_t>(weight)]);
    }
    if (beside) return true;
  }
  return false;
}

/// Whether all corners lie beyond one of the master's sides, by more than a position error of (s, t), or above its
/// plane.
bool surely_outside(const std::array<PrismPoint, 3>& corners, const PrismPositionError& position_error) {
  const auto all_below = [&corners](int coordinate, double level) {
    return corners[0][coordinate] < level && corners[1][coordinate] < level && corners[2][coordinate] < level;
  };
  return all_below(0, -(position_error.s + position_error.t)) || all_below(kS, -position_error.s) ||
         all_below(kT, -position_error.t) || all_below(kDepth, -position_error.depth);
}

PrismPositionError sum_of(const PrismPositionError& a, const PrismPositionError& b) {
  return {a.s + b.s, a.t + b.t, a.depth + b.depth};
}

/// The part of a face that may come to lie over the master face, at a depth >= 0, when its points are shifted; all
/// coordinates are larger by the position error.
ConvexPolygon part_over_master(const std::array<PrismPoint, 3>& corners, const PrismPositionError& position_error,
                               double third) {
  ConvexPolygon part;
  const PrismPoint enlarged(position_error.s + position_error.t + third, position_error.s, position_error.t,
                            position_error.depth);
  for (const PrismPoint& corner : corners) part.add(corner + enlarged);
  for (int coordinate = 0; coordinate <= kDepth; ++coordinate) {
    if (least_of(corners, coordinate) >= 0) continue;
    keep_where_not_negative(part, coordinate);
    if (part.count == 0) break;
  }
  return part;
}

/// On which side of the plane of f the vertices of g certainly lie: 1 all above, -1 all below, 0 unsure. With lambda
/// the barycentric coordinates of a vertex c of g in f, both as shifted, the plane of f passes there within sum
/// |lambda| (depth + gradient x position error of f's vertices) of the one without errors.
int certain_side(const FaceEnclosure& f, const FaceEnclosure& g) {
  const auto steepness = [&f](const PrismPositionError& position_error) {
    return position_error.depth + std::abs(f.depth.per_s) * position_error.s +
           std::abs(f.depth.per_t) * position_error.t;
  };
  const double of_plane = steepness(f.vertex_error), of_vertex = steepness(g.vertex_error);
  const double twice_area = cross_st(f.corners[0], f.corners[1], f.corners[2]);
  const double greatest = greatest_of(f.corners, kDepth);
  int above = 0, below = 0, shared = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    if (f.of_master == g.of_master &&
        std::find(f.vertices.begin(), f.vertices.end(), g.vertices[j]) != f.vertices.end()) {
      ++shared;
      continue;
    }
    const PrismPoint& c = g.corners[j];
    double lambda = 0, widths = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const PrismPoint& a = f.corners[k];
      lambda += std::abs(cross_st(a, f.corners[(k + 1) % 3], c));
      widths += (f.corner_error.s + g.corner_error.s) * (std::abs(c[kT] - a[kT]) + g.corner_error.t) +
                (f.corner_error.t + g.corner_error.t) * std::abs(c[kS] - a[kS]);
    }
    // Shifting leaves the face at least half its area (find_face_enclosure).
    lambda = 2 * (lambda + 8 * widths) / twice_area;
    const double plane =
        f.depth.value + (f.depth.per_s * (c[kS] - f.depth.s_0) + f.depth.per_t * (c[kT] - f.depth.t_0));
    // The plane is as good as its greatest corner, also where it passes near depth 0, and beyond the face less so.
    const double error =
        2 * (of_plane * lambda + of_vertex) + f.relative_rounding * (lambda * greatest + std::abs(c[kDepth]));
    above += plane - c[kDepth] > error ? 1 : 0;
    below += plane - c[kDepth] < -error ? 1 : 0;
  }
  if (shared == 3) return 0;
  return above + shared == 3 ? 1 : below + shared == 3 ? -1 : 0;
}

/// What is needed of a face again and again while its enclosure is found.
struct SeenFace {
  const FaceInPrism& face;
  PrismRounding rounding;          ///< of its vertices
  PrismPositionError of_vertices;  ///< the first step of PrismError
  double greatest_s, greatest_t;
  double farthest_depth;  ///< of a corner from the master's plane, m
  double deepest;         ///< depth of a corner, m
  double distance;        ///< of a corner from p0, m

  SeenFace(const PrismError& error, const FaceInPrism& seen)
      : face(seen),
        rounding(error.rounding(seen.points_Me, seen.corners, seen.shared)),
        of_vertices(error.of_vertices(rounding, seen.rounding_Me)),
        greatest_s(greatest_of(seen.corners, kS)),
        greatest_t(greatest_of(seen.corners, kT)),
        farthest_depth(greatest_of(seen.corners, kDepth)),
        deepest(std::max({seen.corners[0][kDepth], seen.corners[1][kDepth], seen.corners[2][kDepth]})),
        distance(error.distance(greatest_s, greatest_t, farthest_depth)) {}
};

/// Whether a face with just one corner of the master, and its corners a and b, is deeper than 0 all over the master but
/// there, though a may be above 0. Its points are c + l_a (a - c) + l_b (b - c), l_b > 0 or beyond a side of the master
/// through c: let w be the weight that is 0 at that side. Over the master l_a w(a) + l_b w(b) >= 0, so with w(a) < 0
/// l_a is no more than l_b w(b) / -w(a), and the depth l_a d_a + l_b d_b no less than l_b (d_b + d_a w(b) / -w(a)) if
/// d_a < 0.
bool hangs_by_one_corner(const PrismPoint& c, const PrismPoint& a, const PrismPoint& b, double depth_error,
                         const std::array<double, 3>& weight_error) {
  const double d_a = a[kDepth] - depth_error, d_b = b[kDepth] - depth_error;
  if (!(d_b > 0)) return false;
  for (int weight = 0; weight < 3; ++weight) {
    const double w_a = a[weight] + weight_error[static_cast<std::size_t>(weight)];
    const double w_b = b[weight] + weight_error[static_cast<std::size_t>(weight)];
    if (c[weight] == 0 && w_a < 0 && d_b * -w_a > kSafetyFactor * -d_a * w_b) return true;
  }
  return false;
}

bool only_hangs(const SeenFace& seen, const FaceEnclosure& f, const std::array<double, 3>& weight_error) {
  if (f.hinge_depth > 0) return true;
  const std::array<bool, 3>& shared = seen.face.shared;
  if (shared[0] + shared[1] + shared[2] != 1) return false;
  const std::size_t k = shared[0] ? 0 : shared[1] ? 1 : 2;
  const std::array<PrismPoint, 3>& corners = seen.face.corners;
  const PrismPoint &c = corners[k], &a = corners[(k + 1) % 3], &b = corners[(k + 2) % 3];
  const double depth_error = 2 * f.hinge_error.depth;
  return hangs_by_one_corner(c, a, b, depth_error, weight_error) ||
         hangs_by_one_corner(c, b, a, depth_error, weight_error);
}

/// What a face that stands on corners of the master hangs from; false where it surely lies beside the master.
bool find_hinge(const PrismError& error, const SeenFace& seen, FaceEnclosure& f) {
  const std::array<bool, 3>& shared = seen.face.shared;
  f.hinge_depth = 0;
  f.only_hangs = false;
  if (!(shared[0] || shared[1] || shared[2])) return true;
  const PrismPositionError frame = error.of_frame(seen.farthest_depth);
  const double far = 1 + seen.greatest_s + seen.greatest_t;
  f.hinge_error = {seen.of_vertices.s + far * frame.s, seen.of_vertices.t + far * frame.t,
                   seen.of_vertices.depth + far * frame.depth + far * seen.distance * frame.s};
  const std::array<double, 3> weight_error = weight_errors(f.hinge_error, seen.rounding.third);
  if (surely_beside(seen.face.corners, shared, weight_error)) return false;
  f.hinge_depth = kInfinity;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!shared[k]) f.hinge_depth = std::min(f.hinge_depth, seen.face.corners[k][kDepth]);
  }
  f.hinge_depth = std::isfinite(f.hinge_depth) ? std::max(f.hinge_depth - 2 * f.hinge_error.depth, 0.0) : 0;
  f.only_hangs = only_hangs(seen, f, weight_error);
  return true;
}

/// Where and how deep it may be seen; false where nowhere.
bool find_box(const PrismError& error, const SeenFace& seen, FaceEnclosure& f) {
  const std::array<PrismPoint, 3>& corners = seen.face.corners;
  const double deepest = std::max(seen.deepest, 0.0);
  const PrismPositionError widest = sum_of(seen.of_vertices, error.of_frame(deepest));
  f.box = box_of(corners.data(), 3);
  f.greatest = seen.deepest + widest.depth;
  if (std::min({least_of(corners, 0), least_of(corners, kS), least_of(corners, kT), least_of(corners, kDepth)}) < 0) {
    const ConvexPolygon part = part_over_master(corners, widest, error.of_third_weight(deepest, seen.rounding));
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
  return !f.box.empty();
}

/// How many of the master's sides may cut a face, and whether its plane does.
struct Cuts {
  int by_sides = 0, by_plane = 0;

  explicit Cuts(const std::array<PrismPoint, 3>& corners) {
    for (int coordinate = 0; coordinate < kDepth; ++coordinate) by_sides += least_of(corners, coordinate) <= 0 ? 1 : 0;
    by_plane = least_of(corners, kDepth) <= 0 ? 1 : 0;
  }
};

/// How far its points and its border may be shifted.
void find_position_errors(const PrismError& error, const SeenFace& seen, const Cuts& cuts, FaceEnclosure& f) {
  const std::array<PrismPoint, 3>& corners = seen.face.corners;
  const PrismPositionError of_tilt = error.of_tilt(seen.farthest_depth);
  f.vertex_error = seen.of_vertices;
  f.corner_error = {seen.of_vertices.s + of_tilt.s, seen.of_vertices.t + of_tilt.t, 0};
  f.position_error = sum_of(seen.of_vertices, error.of_frame(f.greatest));
  const int all = cuts.by_sides + cuts.by_plane;
  f.cut_error = {all * off_cut(greatest_difference(corners, kS), seen.greatest_s),
                 all * off_cut(greatest_difference(corners, kT), seen.greatest_t), 0};
  f.third_side_error = error.of_third_weight(f.greatest, seen.rounding);
}

/// The face itself, counterclockwise where its doubled area in (s, t) is this.
void copy_face(const SeenFace& seen, double twice_area, FaceEnclosure& f) {
  f.face = seen.face.face;
  f.of_master = seen.face.of_master;
  f.rounding_Me = seen.face.rounding_Me;
  f.vertices = seen.face.vertices;
  f.corners = seen.face.corners;
  f.rounding = seen.rounding;
  f.knows_sides = false;
  f.fixed = seen.face.shared;
  if (twice_area < 0) {
    std::swap(f.vertices[1], f.vertices[2]);
    std::swap(f.corners[1], f.corners[2]);
    std::swap(f.fixed[1], f.fixed[2]);
  }
}

/// Its plane is not known.
void set_facing_unsure(double twice_area, FaceEnclosure& f) {
  f.facing = 0;
  f.sliver = 0.5 * std::abs(twice_area);
  f.depth = {0, 0, 0};
  f.field_error = f.line_error = f.depth_error = kInfinity;
  f.relative_rounding = f.crossing_rounding = 0;
}

/// Its plane, where its facing is sure; a and b are its edges from corner 0.
void find_plane(const PrismError& error, const SeenFace& seen, const Cuts& cuts, double twice_area, const PrismPoint& a,
                const PrismPoint& b, FaceEnclosure& f) {
  f.facing = twice_area < 0 ? -1 : 1;
  f.sliver = 0;
  const double inverse = 1 / std::abs(twice_area);
  const double width_s = std::abs(a[kS]) + std::abs(b[kS]), width_t = std::abs(a[kT]) + std::abs(b[kT]);
  f.depth = {f.corners[0][kDepth], f.corners[0][kS], f.corners[0][kT],
             (a[kDepth] * b[kT] - b[kDepth] * a[kT]) * inverse, (b[kDepth] * a[kS] - a[kDepth] * b[kS]) * inverse};
  f.relative_rounding = kLinearRoundings * u * width_s * width_t * inverse;
  const double cut_rounding = off_line(greatest_difference(f.corners, kDepth), seen.farthest_depth) +
                              std::abs(f.depth.per_s) * off_line(greatest_difference(f.corners, kS), seen.greatest_s) +
                              std::abs(f.depth.per_t) * off_line(greatest_difference(f.corners, kT), seen.greatest_t);
  // At depth 0 it is cut last: what is left then lies over the master, where depths differ by no more than the slopes.
  const double slopes = std::abs(f.depth.per_s) + std::abs(f.depth.per_t);
  const double last_cut = std::min(cut_rounding, kSafetyFactor * (off_line(slopes, 0) + slopes * off_line(1, 1)));
  const double off_slope = kSlopeRoundings * u * inverse;
  const double slopes_off =
      off_slope * ((std::abs(a[kDepth] * b[kT]) + std::abs(b[kDepth] * a[kT])) * f.position_error.s +
                   (std::abs(b[kDepth] * a[kS]) + std::abs(a[kDepth] * b[kS])) * f.position_error.t);
  f.field_error = kSafetyFactor * error.of_function({-f.depth.per_s, -f.depth.per_t, 1}, f.greatest, seen.rounding,
                                                    seen.face.rounding_Me) +
                  slopes_off + cuts.by_sides * cut_rounding + cuts.by_plane * last_cut;
  f.line_error = f.field_error + 2 * last_cut;
  f.depth_error = f.line_error + f.relative_rounding * seen.farthest_depth;
  f.greatest = std::min(f.greatest, f.depth.middle(f.box) + f.depth.half_range(f.box)) + f.depth_error;
  const auto length_of = [&error](const PrismPoint& edge) {
    return error.distance(std::abs(edge[kS]), std::abs(edge[kT]), std::abs(edge[kDepth]));
  };
  f.crossing_rounding = kCrossingRoundings * u * length_of(a) * length_of(b) * inverse / error.twice_area();
}

}  // namespace

CertainOrder certain_order(const FaceEnclosure& g, const FaceEnclosure& f) {
  const int g_over_f = certain_side(f, g);
  const int f_over_g = g_over_f == 0 ? certain_side(g, f) : 0;
  if (g_over_f > 0 || f_over_g < 0) return CertainOrder::before;
  return g_over_f < 0 || f_over_g > 0 ? CertainOrder::after : CertainOrder::unsure;
}

bool surely_unseen(const PrismError& error, bool of_master, const std::array<PrismPoint, 3>& corners) {
  const double distance =
      error.distance(greatest_of(corners, kS), greatest_of(corners, kT), greatest_of(corners, kDepth));
  const double deepest = std::max({corners[0][kDepth], corners[1][kDepth], corners[2][kDepth], 0.0});
  return surely_outside(
      corners, sum_of(error.of_any_vertices(error.greatest_rounding(distance), of_master), error.of_frame(deepest)));
}

// The two steps of PrismError move each corner by no more than corner_error but for an affine map of the plane, which
// leaves windings and sides as they are; and each point that is seen by no more than `position_error`, its depth
// besides by position_error.depth. A depth at a fixed (s, t) is off by what depth - per_s s - per_t t is, a side by its
// cross product with the displacement. Windings: with both edges shifted by up to twice corner_error the product
// changes by at most 4 (s width_t + t width_s + 2 s t).
bool find_face_enclosure(const PrismError& error, const FaceInPrism& face, FaceEnclosure& f) {
  const SeenFace seen(error, face);
  if (!find_hinge(error, seen, f) || !find_box(error, seen, f)) return false;
  const Cuts cuts(face.corners);
  find_position_errors(error, seen, cuts, f);
  f.greatest += f.position_error.depth;
  const double twice_area = cross_st(face.corners[0], face.corners[1], face.corners[2]);
  copy_face(seen, twice_area, f);
  const PrismPoint a = f.corners[1] - f.corners[0], b = f.corners[2] - f.corners[0];
  const double width_s = std::abs(a[kS]) + std::abs(b[kS]), width_t = std::abs(a[kT]) + std::abs(b[kT]);
  const double turn =
      4 * (f.corner_error.s * width_t + f.corner_error.t * width_s + 2 * f.corner_error.s * f.corner_error.t);
  if (std::abs(twice_area) > 2 * turn) {
    find_plane(error, seen, cuts, twice_area, a, b, f);
  } else {
    set_facing_unsure(twice_area, f);
  }
  return !(f.greatest < 0);
}

void find_side_errors(const PrismError& error, FaceEnclosure& f) {
  if (f.knows_sides) return;
  f.knows_sides = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const PrismPoint& a = f.corners[k];
    const PrismPoint& b = f.corners[next];
    const double side_s = b[kS] - a[kS], side_t = b[kT] - a[kT];
    int cuts = 0;
    for (int coordinate = 0; coordinate <= kDepth; ++coordinate)
      cuts += std::min(a[coordinate], b[coordinate]) <= 0 && std::max(a[coordinate], b[coordinate]) >= 0 ? 1 : 0;
    const double cut_s = off_line(std::abs(side_s), std::max(std::abs(a[kS]), std::abs(b[kS])));
    const double cut_t = off_line(std::abs(side_t), std::max(std::abs(a[kT]), std::abs(b[kT])));
    // Corners that are the master's are where they are in both problems.
    const bool moves = !(f.fixed[k] && f.fixed[next]);
    f.side_error[k] = moves ? error.of_function({-side_t, side_s, 0}, f.greatest, f.rounding, f.rounding_Me) : 0;
    f.side_cuts[k] = cuts * (std::abs(side_t) * cut_s + std::abs(side_s) * cut_t);
  }
}

// That of all that position errors may bring over the master, and what its border may pass over then.
double greatest_area(const FaceEnclosure& face) {
  const ConvexPolygon part = part_over_master(face.corners, face.position_error, face.third_side_error);
  return std::min(face.box.area(), (1 + 0x1p-40) * (0.5 * std::abs(twice_area(part))) +
                                       strip_along_border(face.box, face.position_error.s + face.cut_error.s,
                                                          face.position_error.t + face.cut_error.t));
}

}  // namespace pcm::fast
