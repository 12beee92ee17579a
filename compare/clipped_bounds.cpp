// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/clipped_bounds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fast/visible_parts.h"

namespace pcm::compare {
namespace {

constexpr double u = kRoundoff;

/// Where a face is thinner than this part of its sides, its normal is computed exactly; so none is worse than that.
constexpr double kNeedle = 0x1p-16;

/// Roundings are followed one by one on fair master faces; on thinner ones what the engine promises is taken as it is.
constexpr double kThin = 64;

/// As many parts of an element may be dropped where other faces hide some of it.
constexpr double kParts = 8;

/// Strips lie on either side of a line.
double strips_along(double length, double strip) {
  return 2 * strip * (length + 4 * strip);
}

/// A point of the master's plane, in lengths along two directions at right angles, and the slave's depth there.
using SeenPoint = Eigen::Vector3d;

/// The part of a convex polygon where a linear function of the point is not negative.
template <class Height>
std::vector<SeenPoint> cut(const std::vector<SeenPoint>& polygon, const Height& height) {
  std::vector<SeenPoint> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SeenPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = height(a), at_b = height(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

double cross(const SeenPoint& a, const SeenPoint& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// What the master's triangle sees of the slave's at a depth >= 0, in double precision.
std::vector<SeenPoint> seen_part(const std::array<SeenPoint, 3>& master, const std::array<SeenPoint, 3>& slave) {
  std::vector<SeenPoint> part(slave.begin(), slave.end());
  for (std::size_t k = 0; k < 3; ++k) {
    const SeenPoint &a = master[k], side = master[(k + 1) % 3] - a;
    part = cut(part, [&](const SeenPoint& x) { return cross(side, x - a); });
  }
  return cut(part, [](const SeenPoint& x) { return x.z(); });
}

}  // namespace

ClippedBounds::ClippedBounds(const Question& question, const reference::Answer& true_rounded)
    : question_(question), faces_(question) {
  for (const reference::Element& element : true_rounded.elements) elements_.push_back(of_element(element));
}

ClippedBounds::Sight ClippedBounds::sight(Side master, Index master_face, Index slave_face) const {
  Sight sight;
  sight.master = faces_.face(master, master_face);
  const RoundedFaces::Face slave = faces_.face(other(master), slave_face);
  const Eigen::Vector3d& p0 = faces_.corner(master, master_face, 0);
  const Eigen::Vector3d first = (faces_.corner(master, master_face, 1) - p0).stableNormalized();
  const Eigen::Vector3d& n = sight.master.normal_Me;
  const Eigen::Vector3d second = n.cross(first);
  double distance = sight.master.longest, farthest_depth = 0;
  const auto seen = [&](const Eigen::Vector3d& x) -> SeenPoint {
    const Eigen::Vector3d offset = x - p0;
    distance = std::max(distance, sight.master.longest + offset.stableNorm());
    farthest_depth = std::max(farthest_depth, std::abs(n.dot(offset)));
    return {first.dot(offset), second.dot(offset), -n.dot(offset)};
  };
  std::array<SeenPoint, 3> own, others;
  for (std::size_t k = 0; k < 3; ++k) {
    own[k] = seen(faces_.corner(master, master_face, k));
    others[k] = seen(faces_.corner(other(master), slave_face, k));
  }
  // 4 u for each component of N over its terms, 4 u for n itself, and twice all of it.
  const double thinness = sight.master.longest * sight.master.longest / (2 * sight.master.area);
  sight.turn = 16 * u * (1 + std::min(thinness, 1 / kNeedle));
  sight.strip = 32 * u * distance + 2 * sight.turn * (farthest_depth + 16 * u * distance);
  if (thinness > kThin) sight.strip = std::max(sight.strip, fast::kPlaceRoundings * thinness * u * faces_.reach());
  sight.depth_error = (16 * u + sight.turn) * distance;
  const double cosine = std::abs(n.dot(slave.normal_Me));
  sight.slope = n.cross(slave.normal_Me).stableNorm() / cosine;

  const std::vector<SeenPoint> part = seen_part(own, others);
  double sine = 0;  // at the deepest corner
  for (std::size_t i = 0; i < part.size(); ++i) {
    const SeenPoint &a = part[i], &b = part[(i + 1) % part.size()], &before = part[(i + part.size() - 1) % part.size()];
    const double side = (b - a).head<2>().stableNorm(), other_side = (before - a).head<2>().stableNorm();
    sight.outline += side;
    sight.area += cross(a - part[0], b - part[0]) / 2;
    if (a.z() <= sight.depth_error && b.z() <= sight.depth_error) sight.fold += side;
    if (a.z() <= sight.at_tip) continue;
    sight.at_tip = a.z();
    sine = std::abs(cross(b - a, before - a)) / (side * other_side);
  }
  // A part is dropped where its area in (s, t) is less than its extent in t times the uncertainty of s, and the
  // reverse: 64 u R times the gradient, |p2 - p0| / 2A of s and |p1 - p0| / 2A of t.
  const SeenPoint first_edge = own[1] - own[0], second_edge = own[2] - own[0];
  const double doubled_area = cross(first_edge, second_edge);
  double low_s = 0, high_s = 0, low_t = 0, high_t = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double s = cross(part[i] - own[0], second_edge) / doubled_area;
    const double t = cross(first_edge, part[i] - own[0]) / doubled_area;
    low_s = i == 0 ? s : std::min(low_s, s);
    high_s = i == 0 ? s : std::max(high_s, s);
    low_t = i == 0 ? t : std::min(low_t, t);
    high_t = i == 0 ? t : std::max(high_t, t);
  }
  const double width_2 = (high_t - low_t) * second_edge.stableNorm();
  const double width_1 = (high_s - low_s) * first_edge.stableNorm();
  sight.uncertain = 64 * u * faces_.reach() * (width_1 + width_2);
  const double greatest = std::max({others[0].z(), others[1].z(), others[2].z(), 0.0}) + sight.depth_error;
  sight.outline += 8 * sight.strip;
  sight.width = std::min(sight.outline / 2, sight.master.longest);
  const double shift = times(sight.slope, 2 * sight.strip);
  sight.deepest = std::min(greatest, sight.at_tip + sight.depth_error + shift);
  sight.tip_error = sine > 0 ? sight.depth_error + shift / sine : sight.at_tip;
  return sight;
}

ClippedBounds::OfElement ClippedBounds::of_element(const reference::Element& e) const {
  const Sight seen = sight(e.master, e.master_face, e.slave_face);
  GeometryErrors errors;
  errors.normal = seen.turn;
  const double around = e.perimeter + seen.outline;
  // Both sides of a face that is seen nearly edgewise are projected onto almost one line: moving them apart by the
  // strip's width moves where they meet by that over the face's cosine (fast/visible_parts.h).
  const double edgewise = 4 * seen.strip * seen.strip / std::abs(e.cosine);
  const double moved = strips_along(around, seen.strip) + edgewise + (16 * u + seen.turn) * e.area;
  const double folds = std::min(times(e.folds, 2 * seen.depth_error), around * around);
  const bool hidden_in_part = e.area + kHigherOrder * moved < std::abs(seen.area);
  const double strips = moved + folds + (hidden_in_part ? kParts * seen.uncertain : 0);
  const double at_depth_0 =
      seen.fold > 0 ? std::min(seen.fold * (seen.depth_error / seen.slope), seen.fold * seen.outline) : 0;
  errors.area = strips + at_depth_0;

  // Of the depth at a point: what a shift by the strip's width makes along the slave's slope counts as well. Clamped
  // point by point, no depth counts more than the clamp.
  const double deepest = std::max(seen.deepest, e.greatest_penetration);
  const double counted = std::min(deepest, question_.law.max_penetration);
  const double depth_error = std::min(seen.depth_error + times(seen.slope, seen.strip), counted);
  const double volume_error = (e.area + errors.area) * depth_error + strips * counted;

  OfElement result;
  result.sliver = !(e.area > 2 * (errors.area + seen.uncertain));
  errors.penetration = counted;
  // The centroid of u moves within the face; where the volume is known, by no more than its relative error.
  const double volume = e.area * e.penetration;
  const double share = volume > 2 * volume_error ? 2 * volume_error / (volume - volume_error) : 1;
  errors.foot = std::min(1.0, share) * seen.width + 16 * u * faces_.reach();
  if (!result.sliver)
    errors.penetration = std::min(counted, (volume_error + errors.area * e.penetration) / (e.area - errors.area));
  result.bounds = bounds_after_law(question_, e, errors);
  // The greatest depth is that of a corner. Where nothing hides the deepest one that could be seen, strips take no more
  // from it than its angle allows; elsewhere there is the mean.
  const bool tip_is_seen = e.greatest_penetration >= seen.at_tip - seen.depth_error;
  const double from_mean = e.penetration - result.bounds.penetration;
  if (!result.sliver)
    result.greatest_at_least =
        tip_is_seen ? std::max(from_mean, e.greatest_penetration - kHigherOrder * seen.tip_error) : from_mean;
  result.greatest_at_most = e.greatest_penetration + kHigherOrder * (deepest - e.greatest_penetration);
  return result;
}

double ClippedBounds::sliver_area(const fast::Element& e) const {
  const Sight seen = sight(e.master, e.master_face, e.slave_face);
  return kHigherOrder * (strips_along(2 * seen.outline, seen.strip) + kParts * seen.uncertain);
}

double ClippedBounds::sliver_depth(const fast::Element& e) const {
  return sight(e.master, e.master_face, e.slave_face).deepest;
}

}  // namespace pcm::compare
