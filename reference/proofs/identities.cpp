// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/proofs/identities.h"

#include "meshes/base/floating_point_environment.h"
#include "pcm/check.h"
#include "reference/active/area_values.h"
#include "reference/combinatorics/combinatorics.h"
#include "reference/numbers/ball.h"
#include "reference/validate.h"

namespace pcm::reference {
namespace {

/// The integral of x over the triangle (o, p, q), counted positive where it turns like N, in units of |N|.
Vec3<Rational> triangle_moment(const Vec3<Rational>& o, const Vec3<Rational>& p, const Vec3<Rational>& q,
                               const Vec3<Rational>& normal) {
  const Rational share = dot(doubled_normal(o, p, q), normal) / (Rational(2) * dot(normal, normal));
  return Rational(share / Rational(3)) * (o + p + q);
}

/// Adds the fluxes of x n_x, y n_y, z n_z through a face's part inside: component by component, N times its moment.
void add_fluxes(const InsideAreas& areas, Side side, const InsidePart& part, ConvertedPose<Rational>& pose,
                Vec3<Rational>& fluxes) {
  if (!part.has_area) return;
  const std::array<Vec3<Rational>, 3> p = pose.corners(side, part.face);
  const Vec3<Rational> v1 = p[1] - p[0], v2 = p[2] - p[0], normal = cross(v1, v2);
  Vec3<Rational> moment{0, 0, 0};
  using Point = FacePoint<Rational>;
  for_each_triangle(pose, side, part, [&](int winding, const Point& a, const Point& b, const Point& c) {
    const Rational share = Rational(winding) * share_of(a, b, c, Rational(1, 2));
    const Rational x1 = (a.x1 + b.x1 + c.x1) / Rational(3), x2 = (a.x2 + b.x2 + c.x2) / Rational(3);
    moment = moment + share * (p[0] + x1 * v1 + x2 * v2);
  });
  if (side == Side::F)
    for (const Index i : part.overlaps) {
      if (!areas.overlaps[i].equal_normals) continue;
      const std::vector<Vec3<Rational>>& polygon = areas.overlaps[i].polygon;
      for (std::size_t j = 1; j + 1 < polygon.size(); ++j)
        moment = moment - triangle_moment(polygon[0], polygon[j], polygon[j + 1], normal);
    }
  fluxes = fluxes + Vec3<Rational>{normal.x * moment.x, normal.y * moment.y, normal.z * moment.z};
}

}  // namespace

Identities identities_of(const InsideAreas& areas, const ExactPose& exact_pose) {
  Identities identities;
  identities.applicable = true;
  ConvertedPose<Rational> pose(exact_pose);
  Vec3<Rational> sum{0, 0, 0}, limit_sum{0, 0, 0}, fluxes{0, 0, 0};
  Rational limit_volume = 0;
  for (const Side side : {Side::E, Side::F}) {
    const auto faces = face_areas(areas, side, pose);
    sum = sum + vector_area(faces, pose);
    limit_sum = limit_sum + vector_area(faces, pose, &Shares<Rational>::limit);
    limit_volume += flux_third(faces, pose.zero(), pose, &Shares<Rational>::limit);
    for (const InsidePart& part : side == Side::E ? areas.E : areas.F) add_fluxes(areas, side, part, pose, fluxes);
  }
  identities.vector_areas_cancel = sum.x == 0 && sum.y == 0 && sum.z == 0;
  identities.fluxes_agree = fluxes.x == fluxes.y && fluxes.y == fluxes.z;
  identities.limit_closes = limit_sum.x == 0 && limit_sum.y == 0 && limit_sum.z == 0 && limit_volume == fluxes.x;
  identities.volume = nearest_double(fluxes.x);
  return identities;
}

Identities prove_identities(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Problem problem,
                            const Pose& pose_doubles) {
  const DefaultFloatingPoint environment;
  require_fit(mesh_E);
  require_fit(mesh_F);
  require_fit(pose_doubles, {});
  const Surface E = make_surface(mesh_E), F = make_surface(mesh_F);
  if (!E.closed || !F.closed) return {};
  const ExactPose pose(problem, E, F, pose_doubles);
  return identities_of(find_combinatorics(pose).inside_areas(pose), pose);
}

}  // namespace pcm::reference
