// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The stratum nested: a guest inside a ball inside its host.
#include <cmath>

#include "compare/poses/strata.h"

namespace pcm::compare {
namespace {

/// The guest may fill this much of the ball; the rest is room to move.
constexpr double kFill = 0.75;
/// And nothing comes nearer to the host than the ball's radius less this share of it, far above any rounding.
constexpr double kMargin = 0.95;

TriangleMesh scaled_to_fit(TriangleMesh guest, double radius, double room) {
  int halvings = 0;
  while (std::ldexp(radius, -halvings) > room) ++halvings;
  if (halvings == 0) return guest;
  for (Eigen::Vector3d& x : guest.vertices)
    for (int j = 0; j < 3; ++j) x[j] = std::ldexp(x[j], -halvings);
  guest.name += " scaled by 2^-" + std::to_string(halvings);
  return guest;
}

}  // namespace

std::optional<NestedMeshes> nested_meshes(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
  const SurfaceFeatures E(mesh_E), F(mesh_F);
  const InnerBall ball_E = inner_ball(E), ball_F = inner_ball(F);
  const double radius_E = bounding_radius(E), radius_F = bounding_radius(F);
  if (ball_E.radius == 0 && ball_F.radius == 0) return std::nullopt;
  if (ball_E.radius * radius_E >= ball_F.radius * radius_F)
    return NestedMeshes{mesh_E, scaled_to_fit(mesh_F, radius_F, kFill * ball_E.radius), ball_E, Side::E};
  return NestedMeshes{scaled_to_fit(mesh_E, radius_E, kFill * ball_F.radius), mesh_F, ball_F, Side::F};
}

namespace detail {

DrawnPose draw_nested(const FeaturePair& pair, PoseRandom& random) {
  const SurfaceFeatures& guest = pair.host == Side::E ? pair.F : pair.E;
  const Eigen::Vector3d guest_centre = (guest.box_min + guest.box_max) / 2;
  const double room = kMargin * pair.ball.radius - bounding_radius(guest);
  const Eigen::Vector3d direction = random.direction();
  const Eigen::Vector3d place = pair.ball.centre + direction * (random.uniform() * room);
  DrawnPose drawn;
  drawn.pose.A = random.rotation();
  drawn.construction = "inside";
  // The centre of the guest's box goes to the place in the host.
  if (pair.host == Side::E)
    drawn.pose.r = place - ordered_product(drawn.pose.A, guest_centre);
  else
    drawn.pose.r = guest_centre - ordered_product(drawn.pose.A, place);
  return drawn;
}

}  // namespace detail
}  // namespace pcm::compare
