// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/master_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/verify/bounds/bound_arithmetic.h"
#include "fast/clipped/visible_parts.h"

namespace pcm::compare {
namespace {

using roundoff::u;

/// Where a face is thinner than this part of its sides, its normal is computed exactly; so none is worse than that.
constexpr double kNeedle = 0x1p-16;

/// Parts thinner than this part of their uncertainty may be dropped by a right engine. The verdict's own number: an
/// engine that drops more is wrong, not right by a wider bound.
constexpr double kSliver = 1.0 / 16;
static_assert(fast::kSliver <= kSliver);

}  // namespace

MasterView::MasterView(const RoundedFaces& faces, Side master, Index master_face)
    : faces_(faces), master_(master), master_face_(master_face), face_(faces.face(master, master_face)) {
  const Eigen::Vector3d& p0 = faces_.corner(master, master_face, 0);
  const Eigen::Vector3d& n = face_.normal_Me;
  const Eigen::Vector3d first = (faces_.corner(master, master_face, 1) - p0).stableNormalized();
  const Eigen::Vector3d second = n.cross(first);
  seen_from_Me_ << first.transpose(), second.transpose(), -n.transpose();
  for (const Side side : {Side::E, Side::F}) {
    const std::size_t count = faces_.surface(side).mesh.vertices.size();
    std::vector<SeenPoint>& seen = vertices_[static_cast<std::size_t>(side)];
    seen.reserve(count);
    for (std::size_t v = 0; v < count; ++v) {
      seen.emplace_back(seen_from_Me_ * (faces_.vertex(side, static_cast<Index>(v)) - p0));
    }
  }
  own_ = seen(master, master_face);
  side_s_ = own_[1] - own_[0];
  side_t_ = own_[2] - own_[0];
  length_s_ = side_s_.stableNorm();
  length_t_ = side_t_.stableNorm();
  skew_ = length_s_ * length_t_ / (2 * face_.area);
  // N off by 4 sqrt(2) u |p1 - p0| |p2 - p0|, see rounded_faces.cpp, and n by 4 u more.
  turn_ = kHigherOrder * (4 * std::sqrt(2.0) * std::min(skew_, 1 / kNeedle) + 4) * u;
  // In sums of |components|, as the engine reckons.
  const double sides = (faces_.corner(master, master_face, 1) - p0).lpNorm<1>() *
                       (faces_.corner(master, master_face, 2) - p0).lpNorm<1>();
  tilt_ = 8 * u * (1 + std::min(sides / (2 * face_.area), 1 / kNeedle));
  find_near_faces();
}

void MasterView::find_near_faces() {
  const Extent own = extent(own_);
  const double error = strip(face_.longest + 4 * faces_.max_coordinate(), 4 * faces_.max_coordinate());
  for (const Side side : {Side::E, Side::F}) {
    const std::size_t count = faces_.surface(side).mesh.faces.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Index face = static_cast<Index>(i);
      const SeenFace corners = seen(side, face);
      // Most faces are far along the first axis already.
      const auto is_far = [&](Eigen::Index axis) {
        const double a = corners[0][axis], b = corners[1][axis], c = corners[2][axis];
        return (axis < 2 && std::min({a, b, c}) > own.high[axis] + error) ||
               std::max({a, b, c}) < own.low[axis] - error;
      };
      if (is_far(0) || is_far(1) || is_far(2)) continue;
      if (side != master_ || face != master_face_) near_.push_back({side, face, extent(corners)});
    }
  }
}

SeenFace MasterView::seen(Side side, Index face) const {
  const std::vector<SeenPoint>& vertices = vertices_[static_cast<std::size_t>(side)];
  const Triangle& corners = faces_.surface(side).mesh.faces[static_cast<std::size_t>(face)];
  return {vertices[static_cast<std::size_t>(corners[0])], vertices[static_cast<std::size_t>(corners[1])],
          vertices[static_cast<std::size_t>(corners[2])]};
}

std::vector<SeenPoint> MasterView::seen_part(const SeenFace& slave, double margin, double rise) const {
  return cut(within({slave.begin(), slave.end()}, own_, margin), [&](const SeenPoint& x) { return x.z() + rise; });
}

MasterView::Extent MasterView::extent(std::span<const SeenPoint> polygon) {
  Extent extent{polygon[0].array(), polygon[0].array()};
  for (const SeenPoint& x : polygon) {
    extent.low = extent.low.min(x.array());
    extent.high = extent.high.max(x.array());
  }
  return extent;
}

// Weights have 4 roundings and their gradients 8, so that s and t are each off by 12 u of the distance times their
// gradient: with both along the sides that is a way of 24 u q times the distance, q the skew. What a turn of the lines
// moves a point by grows with its depth.
double MasterView::strip(double distance, double depth) const {
  return 24 * u * skew_ * distance + turn_ * (depth + 16 * u * distance);
}

// A face that hides something of the slave's lies over the master somewhere, not deeper than that one.
double MasterView::most_strip(const SeenFace& slave) const {
  double distance = 0, depth = 0;
  for (const SeenPoint& x : slave) {
    distance = std::max(distance, distance_from_corners(x));
    depth = std::max(depth, std::abs(x.z()));
  }
  return strip(std::max(distance, 2 * face_.longest + depth + faces_.longest_side()), depth);
}

double MasterView::distance_from_corners(const SeenPoint& x) const {
  return std::max({(x - own_[0]).stableNorm(), (x - own_[1]).stableNorm(), (x - own_[2]).stableNorm()});
}

Eigen::Array2d MasterView::weights(const SeenPoint& x) const {
  return Eigen::Array2d(cross(x, side_t_), cross(side_s_, x)) / cross(side_s_, side_t_);
}

double MasterView::place_error(const SeenPoint& x) const {
  const Eigen::Array2d st = weights(x).abs();
  const double distance = (1 + st[0]) * length_s_ + (1 + st[1]) * length_t_ + std::abs(x.z());
  return no_more(2 * tilt_ * std::abs(x.z()) + 17 * u * distance, 65 * u * faces_.placed_max_coordinate());
}

// A face is dropped where what is seen of it has less area in (s, t) than its extent in t times the uncertainty of s,
// and the reverse: the place error times the gradient, |p2 - p0| / 2A of s and |p1 - p0| / 2A of t. So is a part of it
// where others may hide some, for e = kSliver times that error: where it has no more area than e q times its extents
// along both gradients, q = |p1 - p0| |p2 - p0| / 2A. With a diameter d these add up to no more than c d, c the length
// of the sum or of the difference of the gradients' directions. A convex set has no less than half its diameter times
// its least width, and a polygon's least width is that from one of its sides: so the part lies in a strip no wider than
// 2 e q c along one of the lines that made it. Those are the sight's own, with all parts on one side, and those of the
// faces that hide something, with parts on both. A single face leaves no more than five parts. Strips that a right
// engine sees between faces that hide what lies behind both are as wide as their lines are off.
void MasterView::add_uncertain_areas(const SeenFace& slave, const std::vector<SeenPoint>& part, double place,
                                     const Hiders& hiders, SlaveInView& sight) const {
  if (part.empty()) return;
  Eigen::Array2d low = weights(part[0]), high = low;
  for (const SeenPoint& x : part) {
    const Eigen::Array2d st = weights(x);
    low = low.min(st);
    high = high.max(st);
  }
  sight.uncertain = place * ((high - low)[1] * length_t_ + (high - low)[0] * length_s_);
  if (hiders.faces.empty()) return;
  for (const HidingSide& side : hiders.sides)
    if (!side.joins) sight.parting += std::min(sight.width, length_within(side, false, slave, 2 * sight.strip));
  sight.parting += hiders.folds;
  const SeenPoint along_first = side_s_.stableNormalized(), along_second = side_t_.stableNormalized();
  const double c = std::max((along_first + along_second).stableNorm(), (along_first - along_second).stableNorm());
  const double width = 2 * kSliver * place * skew_ * c;
  const double own = static_cast<double>(part.size()) * 2 * width + sight.outline;
  const double cuts = cuts_within(hiders, slave, part, sight.strip, width, sight.width + 2 * width);
  sight.neglected = width * (own + 2 * cuts);
  if (hiders.faces.size() == 1) sight.neglected = std::min(sight.neglected, 5 * kSliver * sight.uncertain);
}

SlaveInView MasterView::sight(Index slave_face) const {
  const SeenFace slave = seen(opposite(master_), slave_face);
  const Eigen::Vector3d& slave_normal = faces_.face(opposite(master_), slave_face).normal_Me;
  double distance = 0, depth = 0, greatest = 0, place = 0;
  for (const SeenPoint& x : slave) {
    distance = std::max(distance, distance_from_corners(x));
    depth = std::max(depth, std::abs(x.z()));
    greatest = std::max(greatest, x.z());
    place = std::max(place, place_error(x));
  }
  const double most_strip = this->most_strip(slave);
  const std::vector<SeenPoint> part = seen_part(slave, 0, 0);
  SlaveInView sight;
  const Hiders hiders = part.empty() ? Hiders{} : find_hiders(slave_face, part, most_strip);
  sight.hiders = static_cast<int>(hiders.faces.size());
  sight.mistaken = hiders.mistaken;
  sight.strip = strip(std::max(distance, hiders.distance), depth);
  sight.depth_error = (16 * u + turn_) * distance;
  sight.slope = face_.normal_Me.cross(slave_normal).stableNorm() / std::abs(face_.normal_Me.dot(slave_normal));
  const std::vector<SeenPoint> at_most =
      seen_part(slave, 2 * most_strip, sight.depth_error + times(sight.slope, most_strip));
  sight.outline = outline_of(at_most) + 8 * sight.strip;
  if (faces_.straddles(master_, master_face_, opposite(master_), slave_face))
    sight.surfacing = area_near_zero(seen_part(slave, 0, sight.depth_error), sight.depth_error);
  sight.area = area_of(part);
  double sine = 0;  // at the deepest corner
  for (std::size_t i = 0; i < part.size(); ++i) {
    const SeenPoint &a = part[i], &b = part[(i + 1) % part.size()], &before = part[(i + part.size() - 1) % part.size()];
    const double side = (b - a).head<2>().stableNorm(), other_side = (before - a).head<2>().stableNorm();
    sight.at_lowest = i == 0 ? a.z() : std::min(sight.at_lowest, a.z());
    if (a.z() <= sight.at_tip) continue;
    sight.at_tip = a.z();
    sine = std::abs(cross(b - a, before - a)) / (side * other_side);
  }
  sight.width = std::min(sight.outline / 2, face_.longest);
  add_uncertain_areas(slave, part, std::max(place, hiders.place), hiders, sight);
  const double depth_change = times(sight.slope, 2 * sight.strip);
  sight.deepest = std::min(greatest, deepest_over_master(slave_face, sight.strip)) + sight.depth_error;
  sight.tip_error = sine > 0 ? sight.depth_error + depth_change / sine : sight.at_tip;
  limit(sight);
  return sight;
}

// What a right engine sees lies over the master and beneath the slave face, each grown by the strip's width; where
// their sides meet at a sharp corner that reaches far.
double MasterView::deepest_over_master(Index slave_face, double strip) const {
  const SeenFace slave = seen(opposite(master_), slave_face);
  const DepthField depth = depth_field(opposite(master_), slave_face, strip);
  if (!is_wider_than(strip)) return std::numeric_limits<double>::infinity();
  double deepest = 0;
  for (const SeenPoint& x : overlap(slave, slave, 2 * strip)) {
    const double from_corner = (x - depth.corner).head<2>().stableNorm();
    deepest =
        std::max(deepest, depth.at(x) + times(depth.error_per_distance, from_corner) + depth.slope.norm() * strip);
  }
  return std::isfinite(depth.error) ? deepest : depth.error;
}

// A cut puts a point between the ends of a segment. With W_k the greatest weight of that kind that a corner of the
// slave face has, each weight there has three roundings of up to 2 W_k u, so that after four cuts it is off by 24 u W_k
// from a point of the face. Where the master's side k cuts a segment with such ends it therefore does so too far along,
// by that over what the weight changes from end to end, and the depth is off by 24 u W_k times what it changes for the
// weight along the segment. Segments are the slave face's edges and the master's sides, along each of which two weights
// change by 1 from corner to corner.
double MasterView::overshoot(Index slave_face, double strip) const {
  const SeenFace slave = seen(opposite(master_), slave_face);
  const DepthField depth = depth_field(opposite(master_), slave_face, strip);
  const double anywhere = 6 * faces_.placed_max_coordinate();
  if (!is_wider_than(strip) || !std::isfinite(depth.error)) return anywhere;
  std::array<Eigen::Array4d, 3> corners;  // weights, depth
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Array2d st = weights(slave[k]);
    corners[k] << 1 - st.sum(), st, slave[k].z();
  }
  Eigen::Array4d greatest = Eigen::Array4d::Zero();
  Eigen::Array3d rise = Eigen::Array3d::Zero();
  double range = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    greatest = greatest.max(corners[k].abs());
    const Eigen::Array4d edge = (corners[next] - corners[k]).abs();
    range = std::max(range, edge[3]);
    rise = rise.max(edge[3] / edge.head<3>());
    const double along_side = std::abs(depth.at(own_[next]) - depth.at(own_[k]));
    for (const std::size_t weight : {k, next}) {
      double& most = rise[static_cast<Eigen::Index>(weight)];
      most = std::max(most, along_side);
    }
  }
  return no_more(no_more(24 * u * ((greatest.head<3>() * rise).sum() + greatest[3]), range), anywhere);
}

// Two points of bodies that touch are no farther apart than 6 times the greatest coordinate, a part of the face has no
// greater area than the face, and a convex one no longer border than its triangle's. A face whose normal the doubles
// here can't tell gives no better numbers, or none.
void MasterView::limit(SlaveInView& sight) const {
  const double anywhere = 6 * faces_.placed_max_coordinate(), whole = greatest_area();
  sight.uncertain = no_more(sight.uncertain, whole);
  sight.neglected = no_more(sight.neglected, sight.hiders == 0 ? 0 : whole);
  sight.area = no_more(sight.area, whole);
  sight.strip = no_more(sight.strip, face_.longest);
  sight.outline = no_more(sight.outline, 3 * face_.longest + 8 * sight.strip);
  sight.parting = no_more(sight.parting, std::numeric_limits<double>::infinity());
  sight.surfacing = no_more(sight.surfacing, whole);
  sight.mistaken = no_more(sight.mistaken, whole);
  sight.width = no_more(sight.width, face_.longest);
  sight.depth_error = no_more(sight.depth_error, anywhere);
  sight.slope = no_more(sight.slope, std::numeric_limits<double>::infinity());
  sight.deepest = no_more(sight.deepest, anywhere);
  sight.at_tip = no_more(sight.at_tip, sight.deepest);
  sight.at_lowest = no_more(sight.at_lowest, sight.deepest);
  sight.tip_error = no_more(sight.tip_error, sight.at_tip);
}

}  // namespace pcm::compare
