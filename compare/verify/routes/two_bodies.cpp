// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/routes/two_bodies.h"

#include <Eigen/Geometry>

#include "compare/verify/routes/asks.h"

namespace pcm::compare {
namespace {

/// One of the 24 rotations that turn axes onto axes: products with it are exact.
Eigen::Matrix3d turn_of_axes(std::uint64_t which) {
  const auto first = static_cast<Eigen::Index>(which % 3),
             second = (first + 1 + static_cast<Eigen::Index>(which / 3 % 2)) % 3;
  const Eigen::Vector3d x = (which / 6 % 2 == 0 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(first);
  const Eigen::Vector3d y = (which / 12 % 2 == 0 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(second);
  Eigen::Matrix3d A;
  A << x, y, x.cross(y);
  return A;
}

/// A turn about one of the six half axes by the angle 2^-13, orthogonal but for roundings.
Eigen::Matrix3d small_turn(std::uint64_t which) {
  constexpr double t = 0x1p-14;  // The tangent of half the angle.
  const auto axis = static_cast<Eigen::Index>(which % 3), second = (axis + 1) % 3, third = (axis + 2) % 3;
  const double sine = (which / 3 % 2 == 0 ? 1.0 : -1.0) * (2 * t / (1 + t * t));
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R(second, second) = R(third, third) = (1 - t * t) / (1 + t * t);
  R(third, second) = sine;
  R(second, third) = -sine;
  return R;
}

Eigen::Vector3d centre_of_box(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : mesh.vertices) box.extend(x);
  return box.center();
}

}  // namespace

fast::Scene scene_of(const fast::Pairing& pairing, const Wanted& wanted, const fast::Savings& savings) {
  fast::Scene scene(savings);
  scene.add_body(pairing.surface_E());
  scene.add_body(pairing.surface_F());
  scene.add_pairing(0, 1, pairing.law(), pairing.mode(), pairing.scheme(), wanted);
  return scene;
}

TwoBodies::TwoBodies(const Pose& pose, const Velocity& velocity)
    : TwoBodies(pose, velocity, bits_of(pose, velocity, Draw::bodies) % 24,
                bits_of(pose, velocity, Draw::bodies) / 24 % 2 == 0) {}

TwoBodies::TwoBodies(const Pose& pose, const Velocity& velocity, std::uint64_t turn, bool spins) {
  const Eigen::Matrix3d Q = turn_of_axes(turn);
  E.pose = {Q, -0.5 * (Q * pose.r)};
  F.pose = {Q * pose.A, 0.5 * (Q * pose.r)};
  E.velocity.v = -0.5 * (Q * velocity.v);
  F.velocity = {0.5 * (Q * velocity.v), Q * velocity.w};
  if (!spins) return;
  E.velocity.w = -0.5 * (Q * velocity.w);
  F.velocity.w = 0.5 * (Q * velocity.w);
  carried_W = E.velocity.w.cross(F.pose.r - E.pose.r);
  F.velocity.v += carried_W;
}

fast::BodyState stepped(const fast::BodyState& F, const TriangleMesh& mesh, double step, std::uint64_t which) {
  fast::BodyState nearby = F;
  nearby.pose.A = small_turn(which % 6) * F.pose.A;
  if (which / 6 % 2 == 0) {
    nearby.pose.r.x() += step;
  } else {
    const Eigen::Vector3d centre = centre_of_box(mesh);
    nearby.pose.r += F.pose.A * centre - nearby.pose.A * centre;
  }
  return nearby;
}

}  // namespace pcm::compare
