// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/verify/bounds/bound_arithmetic.h"
#include "compare/verify/bounds/master_view.h"

/// Which faces may hide something of a slave face, and along which lines.
namespace pcm::compare {
namespace {

using roundoff::u;

}  // namespace

bool MasterView::side_parts(Side side_a, Index a, Side side_b, Index b, double strip) const {
  const SeenFace seen_b = seen(side_b, b);
  const Triangle& corners_a = faces_.surface(side_a).mesh.faces[static_cast<std::size_t>(a)];
  const Triangle& corners_b = faces_.surface(side_b).mesh.faces[static_cast<std::size_t>(b)];
  return some_side_parts(seen(side_a, a), strip, [&](std::size_t k, const auto& is_beyond) {
    for (std::size_t i = 0; i < 3; ++i) {
      const bool shared = side_a == side_b && (corners_b[i] == corners_a[k] || corners_b[i] == corners_a[(k + 1) % 3]);
      if (!shared && !is_beyond(seen_b[i])) return false;
    }
    return true;
  });
}

bool MasterView::side_parts(Side side, Index face, const std::vector<SeenPoint>& polygon, double strip) const {
  return some_side_parts(seen(side, face), strip, [&](std::size_t, const auto& is_beyond) {
    return std::all_of(polygon.begin(), polygon.end(), is_beyond);
  });
}

int MasterView::side_of_plane(Side side_a, Index a, Side side_b, Index b) const {
  const RoundedFaces::Face plane = faces_.face(side_a, a);
  const Eigen::Vector3d& a0 = faces_.corner(side_a, a, 0);
  const double cosine = -plane.normal_Me.dot(face_.normal_Me);
  if (!(std::abs(cosine) > plane.normal_error + turn_)) return 0;
  const Triangle& corners_a = faces_.surface(side_a).mesh.faces[static_cast<std::size_t>(a)];
  const Triangle& corners_b = faces_.surface(side_b).mesh.faces[static_cast<std::size_t>(b)];
  bool beyond = true, before = true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (side_a == side_b && std::find(corners_a.begin(), corners_a.end(), corners_b[i]) != corners_a.end()) continue;
    const Eigen::Vector3d offset = faces_.corner(side_b, b, i) - a0;
    const double along = std::copysign(1, cosine) * plane.normal_Me.dot(offset);
    const double error = (plane.normal_error + 8 * u) * offset.stableNorm();
    beyond = beyond && along > error;
    before = before && along < -error;
  }
  return beyond ? 1 : before ? -1 : 0;
}

int MasterView::order(Side side_b, Index b, Side side_a, Index a) const {
  const int b_from_a = side_of_plane(side_a, a, side_b, b), a_from_b = side_of_plane(side_b, b, side_a, a);
  if (b_from_a > 0 || a_from_b < 0) return 1;
  return b_from_a < 0 || a_from_b > 0 ? -1 : 0;
}

// Through a corner, as seen, along the plane of the face's normal m: in lengths along both directions and depths that
// is where m . (x - corner) = 0, so that an error of m by an angle turns the depth's slope, the tangent of the angle
// between both planes, by that over the square of the cosine. The engine compares two faces by the heights of the
// corners of one over the plane of the other, which are as sure as the distance between them allows.
MasterView::DepthField MasterView::depth_field(Side side, Index face, double strip) const {
  const RoundedFaces::Face plane = faces_.face(side, face);
  const Eigen::Vector3d m = seen_from_Me_ * plane.normal_Me;
  const double cosine = std::abs(m.z()), turn = plane.normal_error + turn_ + 16 * u;
  const SeenFace corners = seen(side, face);
  DepthField field{
      corners[0], m, turn, plane.plane_error, Eigen::Vector2d::Zero(), 0, std::numeric_limits<double>::infinity(), 0};
  for (const SeenPoint& x : corners) field.reach = std::max(field.reach, distance_from_corners(x));
  if (!(cosine > 4 * turn)) return field;
  field.slope = -m.head<2>() / m.z();
  field.error = kHigherOrder * ((16 * u + turn_) * field.reach + field.slope.norm() * strip);
  field.error_per_distance = kHigherOrder * 2 * turn / (cosine * cosine);
  return field;
}

std::vector<SeenPoint> MasterView::overlap(const SeenFace& a, const SeenFace& b, double margin) const {
  // A corner of angle a reaches margin / sin(a / 2) farther when its sides are moved outward, and sin(a / 2) is no less
  // than half the master's width over its longest side: so no more than 4 longest sides.
  const Extent own = extent(own_);
  const double around = 16 * (face_.longest + margin);
  const double left = own.low.x() - around, right = own.high.x() + around;
  const double near = own.low.y() - around, far = own.high.y() + around;
  std::vector<SeenPoint> polygon = {{left, near, 0}, {right, near, 0}, {right, far, 0}, {left, far, 0}};
  for (const SeenFace* const face : {&own_, &a, &b}) polygon = within(polygon, *face, margin);
  return polygon;
}

bool MasterView::is_sliver(Side side, Index face, double strip) const {
  const SeenFace corners = seen(side, face);
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, (corners[(k + 1) % 3] - corners[k]).head<2>().stableNorm());
  return std::abs(cross(corners[1] - corners[0], corners[2] - corners[0])) <= 2 * strip * longest;
}

MasterView::Hiders MasterView::find_hiders(Index slave_face, const std::vector<SeenPoint>& part, double strip,
                                           bool slivers) const {
  const Side slave = opposite(master_);
  const SeenFace seen_slave = seen(slave, slave_face);
  const DepthField of_slave = depth_field(slave, slave_face, strip);
  const Extent of_part = extent(part);
  const double most = no_more(outline_of(part) / 2 + 4 * strip, face_.longest);
  Hiders hiders;
  for (const NearFace& near : near_) {
    const auto& [side, face, of_face] = near;
    if (side == slave && face == slave_face) continue;
    if ((of_face.low.head<2>() > of_part.high.head<2>() + strip).any()) continue;
    if ((of_face.high.head<2>() < of_part.low.head<2>() - strip).any()) continue;
    if (side_parts(master_, master_face_, side, face, strip) || side_parts(slave, slave_face, side, face, strip) ||
        side_parts(side, face, part, strip))
      continue;
    if (side_parts(side, face, slave, slave_face, strip) && !(slivers && is_sliver(side, face, strip))) continue;
    const int order_to_slave = order(side, face, slave, slave_face);
    if (order_to_slave > 0) continue;
    const SeenFace seen_face = seen(side, face);
    const DepthField of_hider = depth_field(side, face, strip);
    if (is_wider_than(strip)) {
      const std::vector<SeenPoint> over = overlap(seen_slave, seen_face, 2 * strip);  // where it may hide something
      const double depth_error = of_hider.error_between(of_slave);
      const double before_error = depth_error + of_slave.error_between(of_hider);
      const auto surely_after = [&](const SeenPoint& x) { return of_slave.at(x) - of_hider.at(x) + before_error < 0; };
      const auto surely_above = [&](const SeenPoint& x) { return of_hider.at(x) + depth_error < 0; };
      if (std::all_of(over.begin(), over.end(), surely_after) || std::all_of(over.begin(), over.end(), surely_above))
        continue;
    }
    add_folds(slave_face, near, strip, most, hiders);
    hiders.faces.push_back(&near);
    for (const SeenPoint& x : seen_face) {
      hiders.distance = std::max(hiders.distance, distance_from_corners(x));
      hiders.place = std::max(hiders.place, place_error(x));
    }
  }
  hiders.sides = hiding_sides(hiders.faces, strip);
  return hiders;
}

// Where the hider is at depth 0, its height over the master is off by the error of a height over a plane. Where it
// passes through the slave face, so is the slave's height over the hider, and the hider's over the slave, which is
// that times the cosine of the slave's angle over that of the hider's. Our roundings count as well. What lies beside
// one of the three faces is in the strips along its sides.
void MasterView::add_folds(Index slave_face, const NearFace& hider, double strip, double most, Hiders& hiders) const {
  const Side slave = opposite(master_);
  const SeenFace seen_slave = seen(slave, slave_face), seen_hider = seen(hider.side, hider.face);
  const auto add = [&](const SeenFace& face, const SeenFace& other, double error) {
    const std::vector<SeenPoint> over = within(within({face.begin(), face.end()}, own_, 0), other, 0);
    const auto surely_below = [&](const SeenPoint& x) { return x.z() > error; };
    const auto surely_above = [&](const SeenPoint& x) { return x.z() < -error; };
    if (std::all_of(over.begin(), over.end(), surely_below) || std::all_of(over.begin(), over.end(), surely_above))
      return;
    hiders.folds += no_more(outline_of(over) / 2 + 4 * strip, most);
    hiders.mistaken += area_near_zero(over, error);
  };
  if (faces_.straddles(master_, master_face_, hider.side, hider.face)) {
    double farthest = 0;
    for (const SeenPoint& x : seen_hider) farthest = std::max(farthest, distance_from_corners(x));
    add(seen_hider, seen_slave, 2 * face_.plane_error * farthest);
  }
  if (faces_.straddles(slave, slave_face, hider.side, hider.face) &&
      faces_.straddles(hider.side, hider.face, slave, slave_face)) {
    const RoundedFaces::Face plane = faces_.face(hider.side, hider.face);
    const RoundedFaces::Face slave_plane = faces_.face(slave, slave_face);
    SeenFace over_hider = seen_slave;  // depths replaced by heights over the hider
    double farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& x = faces_.corner(slave, slave_face, k);
      for (std::size_t i = 0; i < 3; ++i)
        farthest = std::max(farthest, (x - faces_.corner(hider.side, hider.face, i)).stableNorm());
      over_hider[k].z() = plane.normal_Me.dot(x - faces_.corner(hider.side, hider.face, 0));
    }
    const double turned = std::abs(plane.normal_Me.dot(face_.normal_Me) / slave_plane.normal_Me.dot(face_.normal_Me));
    add(over_hider, seen_hider, 2 * farthest * std::max(plane.plane_error, times(slave_plane.plane_error, turned)));
  }
}

std::vector<MasterView::HidingSide> MasterView::hiding_sides(const std::vector<const NearFace*>& hiders,
                                                             double strip) const {
  struct Found {
    std::array<Index, 3> key;  // surface, vertex of smaller index, the other
    SeenPoint third;
  };
  std::vector<Found> found;
  for (const NearFace* const hider : hiders) {
    const Triangle& corners = faces_.surface(hider->side).mesh.faces[static_cast<std::size_t>(hider->face)];
    const SeenFace seen_corners = seen(hider->side, hider->face);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
      found.push_back({{static_cast<Index>(hider->side), low, high}, seen_corners[(k + 2) % 3]});
    }
  }
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.key < b.key; });
  std::vector<HidingSide> sides;
  for (std::size_t i = 0; i < found.size();) {
    const auto& [surface, low, high] = found[i].key;
    const std::vector<SeenPoint>& vertices = vertices_[static_cast<std::size_t>(surface)];
    const SeenPoint &from = vertices[static_cast<std::size_t>(low)], &to = vertices[static_cast<std::size_t>(high)];
    const bool is_shared = i + 1 < found.size() && found[i + 1].key == found[i].key;
    const auto height = [&](std::size_t k) { return cross(to - from, found[k].third - from); };
    const double certain = 2 * strip * (to - from).head<2>().stableNorm();
    const bool joins = is_shared && ((height(i) > certain && height(i + 1) < -certain) ||
                                     (height(i) < -certain && height(i + 1) > certain));
    sides.push_back({from, to, joins});
    i += is_shared ? 2 : 1;
  }
  return sides;
}

double MasterView::length_within(const HidingSide& side, bool whole_line, const SeenFace& slave, double margin) const {
  const SeenPoint to = side.to - side.from;
  const double length = to.head<2>().stableNorm();
  if (!(length > 0)) return 2 * margin;
  auto [first, last] = span_within(side.from, to / length, slave, margin);
  if (!whole_line) {
    first = std::max(first, -margin);
    last = std::min(last, length + margin);
  }
  return std::max(0.0, last - first);
}

std::pair<double, double> MasterView::span_within(const SeenPoint& through, const SeenPoint& along,
                                                  const SeenFace& slave, double margin) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double first = -kInfinity, last = kInfinity;
  for (const SeenFace* const face : {&own_, &slave}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2d inward = inward_of_side(*face, k);
      const double height = inward.dot((through - (*face)[k]).head<2>()) + margin;
      const double rise = inward.dot(along.head<2>());
      if (rise > 0) first = std::max(first, -height / rise);
      if (rise < 0) last = std::min(last, -height / rise);
      if (rise == 0 && height < 0) return {0, -1};
    }
  }
  return {first, last};
}

// A line laid through both ends of a side is off by more farther away, as a lever.
double MasterView::cuts_within(const Hiders& hiders, const SeenFace& slave, const std::vector<SeenPoint>& part,
                               double strip, double width, double most) const {
  double sum = 0;
  for (const HidingSide& side : hiders.sides) {
    const double length = (side.to - side.from).head<2>().stableNorm();
    double farthest = 0;
    for (const SeenPoint& x : part) farthest = std::max(farthest, (x - side.from).head<2>().stableNorm());
    const double lever = 1 + 2 * farthest / length;
    const bool is_sure = strip * lever < length / 16 && strip * lever < most;
    sum += is_sure ? std::min(most, length_within(side, true, slave, 2 * strip * lever + 2 * width)) : most;
  }
  return sum + hiders.folds;
}

}  // namespace pcm::compare
