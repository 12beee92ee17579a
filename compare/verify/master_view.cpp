// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/master_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/verify/bound_arithmetic.h"
#include "fast/clipped/visible_parts.h"

namespace pcm::compare {
namespace {

constexpr double u = kRoundoff;

/// Where a face is thinner than this part of its sides, its normal is computed exactly; so none is worse than that.
constexpr double kNeedle = 0x1p-16;

/// Parts thinner than this part of their uncertainty may be dropped by a right engine. The verdict's own number: an
/// engine that drops more is wrong, not right by a wider bound.
constexpr double kSliver = 1.0 / 16;
static_assert(fast::kSliver <= kSliver);

/// The part of a convex polygon where a linear function of the point is not negative.
template <class Height>
std::vector<Eigen::Vector3d> cut(const std::vector<Eigen::Vector3d>& polygon, const Height& height) {
  std::vector<Eigen::Vector3d> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = height(a), at_b = height(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

/// In the master's plane, m.
double outline_of(const std::vector<Eigen::Vector3d>& polygon) {
  double outline = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    outline += (polygon[(i + 1) % polygon.size()] - polygon[i]).head<2>().stableNorm();
  return outline;
}

/// In the master's plane, m^2, counterclockwise.
double area_of(const std::vector<Eigen::Vector3d>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

/// Where |z| is no more than the error of z, so that its sign may be mistaken, m^2.
double area_near_zero(const std::vector<Eigen::Vector3d>& polygon, double error) {
  const auto not_below = cut(polygon, [&](const Eigen::Vector3d& x) { return x.z() + error; });
  return std::abs(area_of(cut(not_below, [&](const Eigen::Vector3d& x) { return error - x.z(); })));
}

/// In the master's plane.
double cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The direction in the master's plane from a face's side k inward, of unit length; null for a side without length,
/// which bounds nothing.
Eigen::Vector2d inward_of_side(const std::array<Eigen::Vector3d, 3>& face, std::size_t k) {
  const double sign = cross(face[1] - face[0], face[2] - face[0]) < 0 ? -1 : 1;
  const Eigen::Vector2d along = (face[(k + 1) % 3] - face[k]).head<2>();
  const double length = along.stableNorm();
  if (!(length > 0)) return Eigen::Vector2d::Zero();
  return sign / length * Eigen::Vector2d(-along.y(), along.x());
}

/// The part of a convex polygon over a face that is grown by `margin`.
std::vector<Eigen::Vector3d> within(std::vector<Eigen::Vector3d> polygon, const std::array<Eigen::Vector3d, 3>& face,
                                    double margin) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d inward = inward_of_side(face, k);
    polygon = cut(polygon, [&](const Eigen::Vector3d& x) { return inward.dot((x - face[k]).head<2>()) + margin; });
  }
  return polygon;
}

/// Whether `all_beyond(k, is_beyond)` holds for a side k of the face: `is_beyond` says of a point whether it lies on
/// the far side of that one by more than `strip`.
template <class AllBeyond>
bool some_side_parts(const std::array<Eigen::Vector3d, 3>& face, double strip, const AllBeyond& all_beyond) {
  const double sign = cross(face[1] - face[0], face[2] - face[0]) < 0 ? -1 : 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d along = face[(k + 1) % 3] - face[k];
    const double error = strip * along.head<2>().stableNorm();
    if (all_beyond(k, [&](const Eigen::Vector3d& x) { return sign * cross(along, x - face[k]) < -error; })) return true;
  }
  return false;
}

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

MasterView::SeenFace MasterView::seen(Side side, Index face) const {
  const std::vector<SeenPoint>& vertices = vertices_[static_cast<std::size_t>(side)];
  const Triangle& corners = faces_.surface(side).mesh.faces[static_cast<std::size_t>(face)];
  return {vertices[static_cast<std::size_t>(corners[0])], vertices[static_cast<std::size_t>(corners[1])],
          vertices[static_cast<std::size_t>(corners[2])]};
}

std::vector<MasterView::SeenPoint> MasterView::seen_part(const SeenFace& slave, double margin, double rise) const {
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

MasterView::Hiders MasterView::find_hiders(Index slave_face, const std::vector<SeenPoint>& part, double strip) const {
  const Side slave = opposite(master_);
  const SeenFace seen_slave = seen(slave, slave_face);
  const DepthField of_slave = depth_field(slave, slave_face, strip);
  const Extent of_part = extent(part);
  const double most = no_more(outline_of(part) / 2 + 4 * strip, face_.longest);
  Hiders hiders;
  std::vector<const NearFace*> found;
  for (const NearFace& near : near_) {
    const auto& [side, face, of_face] = near;
    if (side == slave && face == slave_face) continue;
    if ((of_face.low.head<2>() > of_part.high.head<2>() + strip).any()) continue;
    if ((of_face.high.head<2>() < of_part.low.head<2>() - strip).any()) continue;
    if (side_parts(master_, master_face_, side, face, strip) || side_parts(slave, slave_face, side, face, strip) ||
        side_parts(side, face, slave, slave_face, strip) || side_parts(side, face, part, strip))
      continue;
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
    found.push_back(&near);
    for (const SeenPoint& x : seen_face) {
      hiders.distance = std::max(hiders.distance, distance_from_corners(x));
      hiders.place = std::max(hiders.place, place_error(x));
    }
  }
  hiders.count = static_cast<int>(found.size());
  hiders.sides = hiding_sides(found, strip);
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

// Through a corner, as seen, along the plane of the face's normal m: in lengths along both directions and depths that
// is where m . (x - corner) = 0, so that an error of m by an angle turns the depth's slope, the tangent of the angle
// between both planes, by that over the square of the cosine. The engine compares two faces by the heights of the
// corners of one over the plane of the other, which are as sure as the distance between them allows.
MasterView::DepthField MasterView::depth_field(Side side, Index face, double strip) const {
  const RoundedFaces::Face plane = faces_.face(side, face);
  const Eigen::Vector3d m = seen_from_Me_ * plane.normal_Me;
  const double cosine = std::abs(m.z()), turn = plane.normal_error + turn_ + 16 * u;
  const SeenFace corners = seen(side, face);
  DepthField field{corners[0], Eigen::Vector2d::Zero(), 0, std::numeric_limits<double>::infinity(), 0};
  for (const SeenPoint& x : corners) field.reach = std::max(field.reach, distance_from_corners(x));
  if (!(cosine > 4 * turn)) return field;
  field.slope = -m.head<2>() / m.z();
  field.error = kHigherOrder * ((16 * u + turn_) * field.reach + field.slope.norm() * strip);
  field.error_per_distance = kHigherOrder * 2 * turn / (cosine * cosine);
  return field;
}

std::vector<MasterView::SeenPoint> MasterView::overlap(const SeenFace& a, const SeenFace& b, double margin) const {
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
  const SeenPoint along = to / length;
  const double infinity = std::numeric_limits<double>::infinity();
  double first = whole_line ? -infinity : -margin, last = whole_line ? infinity : length + margin;
  for (const SeenFace* const face : {&own_, &slave}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2d inward = inward_of_side(*face, k);
      const double height = inward.dot((side.from - (*face)[k]).head<2>()) + margin;
      const double rise = inward.dot(along.head<2>());
      if (rise > 0) first = std::max(first, -height / rise);
      if (rise < 0) last = std::min(last, -height / rise);
      if (rise == 0 && height < 0) return 0;
    }
  }
  return std::max(0.0, last - first);
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
  if (hiders.count == 0) return;
  for (const HidingSide& side : hiders.sides)
    if (!side.joins) sight.parting += std::min(sight.width, length_within(side, false, slave, 2 * sight.strip));
  sight.parting += hiders.folds;
  const SeenPoint along_first = side_s_.stableNormalized(), along_second = side_t_.stableNormalized();
  const double c = std::max((along_first + along_second).stableNorm(), (along_first - along_second).stableNorm());
  const double width = 2 * kSliver * place * skew_ * c;
  const double own = static_cast<double>(part.size()) * 2 * width + sight.outline;
  const double cuts = cuts_within(hiders, slave, part, sight.strip, width, sight.width + 2 * width);
  sight.neglected = width * (own + 2 * cuts);
  if (hiders.count == 1) sight.neglected = std::min(sight.neglected, 5 * kSliver * sight.uncertain);
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
  // A face that hides something of the slave's lies over the master somewhere, not deeper than that one.
  const double farthest = std::max(distance, 2 * face_.longest + depth + faces_.longest_side());
  const double most_strip = strip(farthest, depth);
  const std::vector<SeenPoint> part = seen_part(slave, 0, 0);
  SlaveInView sight;
  const Hiders hiders = part.empty() ? Hiders{} : find_hiders(slave_face, part, most_strip);
  sight.hiders = hiders.count;
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
