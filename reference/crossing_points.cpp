// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/crossing_points.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcm::reference {
namespace {

/// Part of the edge x(t) = a + t d, 0 <= t <= 1.
struct Range {
  Rational first = 0, last = 1;
  Rational middle() const { return (first + last) / Rational(2); }
};

Range clip_by_triangle(const Vec3<Rational>& a, const Vec3<Rational>& b, const std::array<Vec3<Rational>, 3>& corners,
                       const Vec3<Rational>& normal) {
  Range range;
  for (int i = 0; i < 3; ++i) {
    const Vec3<Rational>& u = corners[i];
    const Vec3<Rational> inward = cross(normal, corners[(i + 1) % 3] - u);
    const Rational at_a = dot(inward, a - u), at_b = dot(inward, b - u);
    if (at_a < 0 && at_b < 0) continue;  // Cannot happen to an edge that crosses, perturbed as little as one likes.
    if (at_a < 0) range.first = std::max(range.first, Rational(at_a / (at_a - at_b)));
    if (at_b < 0) range.last = std::min(range.last, Rational(at_a / (at_a - at_b)));
  }
  return range;
}

/// A face that rounding made zero-area is a segment; it meets the edge in a point, or along it.
Range clip_by_flat_triangle(const Vec3<Rational>& a, const Vec3<Rational>& b,
                            const std::array<Vec3<Rational>, 3>& corners) {
  Range range;
  int longest = 0;
  const auto side = [&corners](int i) { return corners[(i + 1) % 3] - corners[i]; };
  for (int i = 1; i < 3; ++i)
    if (dot(side(i), side(i)) > dot(side(longest), side(longest))) longest = i;
  const Vec3<Rational> d = b - a, w = side(longest), from_a = corners[longest] - a;
  if (dot(d, d) == 0) return range;
  const Vec3<Rational> twist = cross(d, w);
  if (dot(twist, twist) != 0) {
    range.first = range.last = dot(cross(from_a, w), twist) / dot(twist, twist);
  } else {
    const Rational start = dot(from_a, d) / dot(d, d), end = dot(from_a + w, d) / dot(d, d);
    range.first = std::max(range.first, std::min(start, end));
    range.last = std::min(range.last, std::max(start, end));
  }
  return range;
}

std::optional<Vec3<Rational>> degenerate_midpoint(const ExactPose& pose, const CrossingId& id) {
  const Side face_side = other(id.edge_side);
  const Triangle& t = pose.face(face_side, id.face);
  const Vertex p{face_side, t[0]}, q{face_side, t[1]}, s{face_side, t[2]};
  const Orientation orientation(pose);
  for (const Index end : id.edge)
    if (orientation.unperturbed(p, q, s, {id.edge_side, end}) != 0) return {};
  const Vec3<Rational> a = pose.point<Rational>({id.edge_side, id.edge[0]});
  const Vec3<Rational> b = pose.point<Rational>({id.edge_side, id.edge[1]});
  const std::array<Vec3<Rational>, 3> corners = pose.corners<Rational>(face_side, id.face);
  const Vec3<Rational> normal = doubled_normal(corners[0], corners[1], corners[2]);
  const Range range =
      dot(normal, normal) == 0 ? clip_by_flat_triangle(a, b, corners) : clip_by_triangle(a, b, corners, normal);
  return a + range.middle() * (b - a);
}

}  // namespace

CrossingPoints::CrossingPoints(const ExactPose& pose, std::vector<CrossingId> ids) : ids_(std::move(ids)) {
  for (const CrossingId& id : ids_) midpoints_.push_back(degenerate_midpoint(pose, id));
}

}  // namespace pcm::reference
