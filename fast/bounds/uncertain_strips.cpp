// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/uncertain_strips.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A cut by a side: twice two differences, two products, a sum, and one to spare.
constexpr double kSideRoundings = 5;

/// How far off the linear function of the side from a to b is, as it is computed over a box. Either end may be the one
/// that it is reckoned from.
double side_roundings(const PrismPoint& a, const PrismPoint& b, const BoxST& box) {
  const auto farthest = [](double low, double high, double x, double y) {
    return std::max({std::abs(low - x), std::abs(high - x), std::abs(low - y), std::abs(high - y)});
  };
  return kSideRoundings * kUnitRoundoff *
         (std::abs(b[kT] - a[kT]) * farthest(box.low_s, box.high_s, a[kS], b[kS]) +
          std::abs(b[kS] - a[kS]) * farthest(box.low_t, box.high_t, a[kT], b[kT]));
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
  void keep_in(const BoxST& box, double error_s, double error_t) {
    keep(s - (box.low_s - error_s), way_s);
    keep((box.high_s + error_s) - s, -way_s);
    keep(t - (box.low_t - error_t), way_t);
    keep((box.high_t + error_t) - t, -way_t);
    keep((1 + error_s + error_t) - s - t, -way_s - way_t);
  }
  /// Keeps what is within (s, t) of a face however its sides are shifted.
  void keep_in(const FaceEnclosure& face, double error_s, double error_t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const PrismPoint& a = face.corners[k];
      const PrismPoint& b = face.corners[(k + 1) % 3];
      const double side_s = b[kS] - a[kS], side_t = b[kT] - a[kT];
      const double error =
          2 * (face.side_error[k] + face.side_cuts[k]) + std::abs(side_s) * error_t + std::abs(side_t) * error_s;
      keep(side_s * (t - a[kT]) - side_t * (s - a[kS]) + error, side_s * way_t - side_t * way_s);
    }
  }
  /// No depth of a face is greater within (s, t) of it.
  double greatest_depth(const FaceEnclosure& face, double error_s, double error_t) const {
    if (face.facing == 0) return std::max(face.greatest, 0.0);
    const double depth = std::max(face.depth.at(s_at(low), t_at(low)), face.depth.at(s_at(high), t_at(high)));
    const double error = face.depth_error + std::abs(face.depth.per_s) * error_s + std::abs(face.depth.per_t) * error_t;
    return std::clamp(depth + error, 0.0, std::max(face.greatest, 0.0));
  }
};

/// Whether a side of a has b on its far side when both faces are shifted: certainly, or but for what position errors
/// make.
struct Separation {
  enum class Kind : std::uint8_t { none, near, certain } found = Kind::none;
  LinearDepth side;  ///< the linear function that is 0 along the side
  double error = 0;  ///< how far position errors may move it
};

void separate(const FaceEnclosure& a, const FaceEnclosure& b, double error_s, double error_t, Separation& best) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const PrismPoint& from = a.corners[k];
    const double side_s = a.corners[next][kS] - from[kS], side_t = a.corners[next][kT] - from[kT];
    double certainty = kInfinity, greatest_error = 0;
    for (std::size_t j = 0; j < 3 && certainty > -1; ++j) {
      if (a.of_master == b.of_master && (b.vertices[j] == a.vertices[k] || b.vertices[j] == a.vertices[next])) continue;
      const double to_s = b.corners[j][kS] - from[kS], to_t = b.corners[j][kT] - from[kT];
      // The position errors pay for the roundings as well.
      const double error = 2 * error_s * (std::abs(side_t) + std::abs(to_t) + 4 * error_t) +
                           2 * error_t * (std::abs(side_s) + std::abs(to_s));
      const double below = side_t * to_s - side_s * to_t;
      greatest_error = std::max(greatest_error, error);
      certainty = std::min(certainty, below > error ? 1.0 : below >= -error ? 0.0 : -1.0);
    }
    if (certainty > 0) {
      best.found = Separation::Kind::certain;
      return;
    }
    if (certainty == 0 && best.found == Separation::Kind::none) {
      best = {Separation::Kind::near, {0, from[kS], from[kT], -side_t, side_s}, greatest_error};
    }
  }
}

/// Two faces that look the same way, both surely, lie on either side of the side they share.
bool share_a_side(const FaceEnclosure& a, const FaceEnclosure& b) {
  if (a.of_master != b.of_master || a.facing == 0 || a.facing != b.facing) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (a.vertices[k] == b.vertices[(j + 1) % 3] && a.vertices[(k + 1) % 3] == b.vertices[j]) return true;
    }
  }
  return false;
}

}  // namespace

double greatest_overlap(const FaceEnclosure& a, const FaceEnclosure& b, const BoxST& box) {
  if (share_a_side(a, b)) return 0;
  const double s = std::max(a.corner_error.s, b.corner_error.s), t = std::max(a.corner_error.t, b.corner_error.t);
  Separation separation;
  separate(a, b, s, t, separation);
  if (separation.found != Separation::Kind::certain) separate(b, a, s, t, separation);
  if (separation.found == Separation::Kind::certain) return 0;
  if (separation.found == Separation::Kind::none) return box.area();
  const double error = 3 * separation.error;
  return std::min(box.area(), 2 * zero_strip(separation.side, {error, error}, box).area);
}

// Its computed area, and what its sides may pass over.
SideStrips sliver(const FaceEnclosure& face, const FaceEnclosure& carrier, double depth, const BoxST& box) {
  PrismPositionError position_error = face.position_error;
  double area = face.sliver;
  if (depth < 0.5 * face.hinge_depth) {
    const double share = kSafetyFactor * depth / face.hinge_depth;
    area *= 2 * share;
    position_error = {std::min(position_error.s, share * face.hinge_error.s),
                      std::min(position_error.t, share * face.hinge_error.t), 0};
  }
  SideStrips all = strips_along_sides(face, position_error.s, position_error.t, carrier, box);
  all.area = std::min(area + all.area, box.area());
  all.volume = std::min(area * depth + all.volume, all.area * depth);
  return all;
}

// What a side passes over lies between where it is and where it was, and within (s, t) of it: in the coordinates lambda
// along the side and (side) x (x - a) across it, whose determinant is 1, that is no more than side_error and roundings
// by the stretch of the side that is within (s, t) of the box. Twice these errors pay for roundings of this itself.
SideStrips strips_along_sides(const FaceEnclosure& face, double s, double t, const FaceEnclosure& carrier,
                              const BoxST& box, const std::array<bool, 3>& sides) {
  const double middle_s = 0.5 * (box.low_s + box.high_s), middle_t = 0.5 * (box.low_t + box.high_t);
  SideStrips strips;
  for (std::size_t k = 0; k < 3; ++k) {
    const PrismPoint& a = face.corners[k];
    const PrismPoint& b = face.corners[(k + 1) % 3];
    const double side_s = b[kS] - a[kS], side_t = b[kT] - a[kT];
    const double inward = side_s * (middle_t - a[kT]) - side_t * (middle_s - a[kS]);
    // Its own border is where it was cut; others are cut along its sides, as far as they reach.
    const double roundings = &carrier != &face  ? side_roundings(a, b, carrier.box)
                             : face.knows_sides ? face.side_cuts[k]
                                                : 0;
    const double within =
        std::abs(side_s) * (0.5 * box.width_t() + t) + std::abs(side_t) * (0.5 * box.width_s() + s) + 2 * roundings;
    if (inward < -within) strips.apart = true;
    if (!sides[k] || std::abs(inward) > within) continue;
    const double by_position_error = std::abs(side_s) * t + std::abs(side_t) * s;
    if (&carrier == &face && !face.knows_sides) {
      // Of the side's extent no more than the box's counts. About each of its ends 2 s times 2 t, and twice that.
      const double extent_s = std::min(std::abs(side_s), box.width_s() + 4 * s);
      const double extent_t = std::min(std::abs(side_t), box.width_t() + 4 * t);
      const double area = kSafetyFactor * (extent_s * t + extent_t * s) + 16 * s * t;
      strips.area += area;
      strips.volume += area * face.greatest;
      continue;
    }
    Stretch stretch{a[kS], a[kT], side_s, side_t};
    stretch.keep_in(box, 2 * s, 2 * t);
    if (&carrier != &face && carrier.facing != 0) stretch.keep_in(carrier, 2 * s, 2 * t);
    if (face.facing != 0) {
      const double error = 2 * (face.depth_error + std::abs(face.depth.per_s) * s + std::abs(face.depth.per_t) * t);
      stretch.keep(a[kDepth] + error, b[kDepth] - a[kDepth]);
    }
    if (stretch.empty()) continue;
    double beyond = 1;
    if (s < std::abs(side_s)) beyond = s / std::abs(side_s);
    if (t < beyond * std::abs(side_t)) beyond = t / std::abs(side_t);
    const double width =
        (face.knows_sides ? std::min(face.side_error[k], by_position_error) : by_position_error) + roundings;
    const double area = width * (stretch.length() + 4 * beyond) + 4 * s * t;
    strips.area += area;
    strips.volume += area * stretch.greatest_depth(carrier, 2 * s, 2 * t);
  }
  strips.area = std::min(strips.area, box.area());
  return strips;
}

// Points between the zeros of both functions are no farther from the line where the given one is 0 than either.
LineStrip strip_along_line(const LinearDepth& function, const LineError& error, const FaceEnclosure& f,
                           const FaceEnclosure& g, const BoxST& box) {
  const double greatest = std::max(f.greatest, 0.0);
  const ZeroStrip strip = zero_strip(function, error, box);
  if (!(strip.area > 0) || strip.everywhere) return {strip.area, strip.area * greatest, strip.everywhere};
  const bool across_s = std::abs(function.per_s) * box.width_s() >= std::abs(function.per_t) * box.width_t();
  const double at_corner = function.at(box.low_s, box.low_t);
  Stretch stretch;
  double wide, slope;
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
  const double away = error.off / slope;
  const double s = (across_s ? 2 * away : 0) + 2 * f.position_error.s + 2 * g.position_error.s;
  const double t = (across_s ? 0 : 2 * away) + 2 * f.position_error.t + 2 * g.position_error.t;
  stretch.keep_in(box, s, t);
  if (f.facing != 0) stretch.keep_in(f, s, t);
  if (g.facing != 0) stretch.keep_in(g, s, t);
  if (stretch.empty()) return {};
  const double area = std::min(strip.area, error.apart / slope * wide * stretch.length() * kSafetyFactor);
  return {area, area * stretch.greatest_depth(f, s, t), false};
}

// With v_0 the depth at the corner from which it is reckoned: the slopes have four roundings and what is made of them
// four more, the product of v_0 and the area five, and a sum. Twice, for the area may be off by a quarter.
double roundings_of_depth(const FaceEnclosure& g, const BoxST& box) {
  const auto& c = g.corners;
  if (std::min({c[0][kDepth], c[1][kDepth], c[2][kDepth]}) >= 0) return 0;
  const PrismPoint a = (c[1] - c[0]).cwiseAbs(), b = (c[2] - c[0]).cwiseAbs();
  const double from_s = std::max(std::abs(box.low_s - c[0][kS]), std::abs(box.high_s - c[0][kS]));
  const double from_t = std::max(std::abs(box.low_t - c[0][kT]), std::abs(box.high_t - c[0][kT]));
  const double sloping =
      (a[kDepth] * b[kT] + b[kDepth] * a[kT]) * from_s + (b[kDepth] * a[kS] + a[kDepth] * b[kS]) * from_t;
  const double level = std::abs(c[0][kDepth]) * (a[kS] * b[kT] + a[kT] * b[kS]);
  return 2 * kUnitRoundoff * (8 * sloping + 6 * level) / cross_st(c[0], c[1], c[2]);
}

// Of a side's extent only that share counts along which the function changes by twice the error.
double zero_strip_at_sides(const FaceEnclosure& face, const std::array<bool, 3>& sides, const LinearDepth& function,
                           double error, const BoxST& box) {
  const double s = face.position_error.s, t = face.position_error.t;
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

// At each s, or t, the zeros of both functions are no farther apart than what they differ by over the slope of either;
// over the width of the box that is off by twice what the function is.
ZeroStrip zero_strip(const LinearDepth& function, const LineError& error, const BoxST& box) {
  const double middle = std::abs(function.middle(box)), half_range = function.half_range(box);
  if (middle - half_range > error.off) return {};
  if (middle + half_range <= error.off) return {box.area(), true};
  const auto across = [&error](double slope, double width) {
    const double least_rise = std::abs(slope) * width - 2 * error.off;
    return least_rise > error.apart ? width * (kSafetyFactor * error.apart / least_rise) : width;
  };
  const double across_s = across(function.per_s, box.width_s()), across_t = across(function.per_t, box.width_t());
  return {std::min(across_s * box.width_t(), across_t * box.width_s()), false};
}

}  // namespace pcm::fast
