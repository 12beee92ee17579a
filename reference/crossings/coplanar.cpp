// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/crossings/coplanar.h"

#include <algorithm>
#include <utility>

namespace pcm::reference {
namespace {

using Polygon3 = std::vector<Vec3<Rational>>;

/// What of the polygon lies on the inner side of the directed line from u, with the inward direction given.
Polygon3 clip(const Polygon3& polygon, const Vec3<Rational>& u, const Vec3<Rational>& inward) {
  Polygon3 kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3<Rational>& a = polygon[i];
    const Vec3<Rational>& b = polygon[(i + 1) % polygon.size()];
    const Rational at_a = dot(inward, a - u), at_b = dot(inward, b - u);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) kept.push_back(a + Rational(at_a / (at_a - at_b)) * (b - a));
  }
  return kept;
}

/// v = share * n for parallel vectors.
Rational ratio(const Vec3<Rational>& v, const Vec3<Rational>& n) {
  return dot(v, n) / dot(n, n);
}

/// Sign of the first non-zero of n_z, n_y, n_x: where the tie rule moves E from a face of F with this normal.
int tie_rule_side(const Vec3<Rational>& n) {
  for (const Rational* component : {&n.z, &n.y, &n.x})
    if (*component != 0) return *component > 0 ? 1 : -1;
  return 0;
}

bool in_one_plane(const Orientation& orientation, Index e, Index f) {
  const ExactPose& pose = orientation.pose();
  const Triangle& p = pose.face(Side::E, e);
  const Triangle& q = pose.face(Side::F, f);
  return std::all_of(q.begin(), q.end(), [&](Index v) {
    return orientation.exact_orientation({Side::E, p[0]}, {Side::E, p[1]}, {Side::E, p[2]}, {Side::F, v}) == 0;
  });
}

}  // namespace

std::vector<CoplanarOverlap> find_coplanar_overlaps(const ExactPose& pose, const std::vector<IndexPair>& candidates) {
  const Orientation orientation(pose);
  std::vector<CoplanarOverlap> overlaps;
  for (const auto& [e, f] : candidates) {
    if (!in_one_plane(orientation, e, f)) continue;
    const auto p = pose.corners<Rational>(Side::E, e);
    const auto q = pose.corners<Rational>(Side::F, f);
    const Vec3<Rational> normal_E = doubled_normal(p[0], p[1], p[2]);
    const Vec3<Rational> normal_F = doubled_normal(q[0], q[1], q[2]);
    if (dot(normal_E, normal_E) == 0 || dot(normal_F, normal_F) == 0) continue;  // zero-area by rounding
    Polygon3 polygon(p.begin(), p.end());
    for (int i = 0; i < 3; ++i) polygon = clip(polygon, q[i], cross(normal_F, q[(i + 1) % 3] - q[i]));
    Vec3<Rational> area{0, 0, 0};
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      area = area + Rational(1, 2) * doubled_normal(polygon[0], polygon[i], polygon[i + 1]);
    if (dot(area, area) == 0) continue;
    CoplanarOverlap overlap;
    overlap.face_E = e;
    overlap.face_F = f;
    overlap.equal_normals = dot(normal_E, normal_F) > 0;
    overlap.share_E = ratio(area, normal_E);
    overlap.share_F = overlap.equal_normals ? ratio(area, normal_F) : Rational(-ratio(area, normal_F));
    overlap.E_above_F = tie_rule_side(normal_F) > 0;
    overlap.polygon = std::move(polygon);
    overlaps.push_back(std::move(overlap));
  }
  return overlaps;
}

}  // namespace pcm::reference
