// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/force/force_problem.h"

#include <array>

#include "fast/base/geometry.h"

namespace pcm::fast {

ForceProblem::ForceProblem(const ContactLaw& contact_law, const Pose& pose_F, const Velocity& velocity_F,
                           const Wanted& wanted)
    : law(contact_law), stiffness(contact_law), pose(pose_F), velocity(velocity_F) {
  keep_elements = wanted.elements;
  with_statistics = wanted.elements || wanted.statistics;
  with_tangent = wanted.tangent;
  with_velocities = law.damping != 0 || law.friction != 0 || with_statistics;
}

ForceLimits force_limits(const ForceProblem& problem, Side master) {
  const auto three = [](const Eigen::Vector3d& v) { return std::array<double, 3>{v[0], v[1], v[2]}; };
  ForceLimits limits;
  limits.law = problem.law;
  limits.c_l = problem.stiffness.c_l;
  limits.master_E = master == Side::E;
  limits.shift = limits.master_E ? problem.stiffness.shift_from_E : problem.stiffness.shift_from_F;
  limits.with_velocities = problem.with_velocities;
  limits.r_Me = three(problem.pose.r);
  limits.v_Me = three(problem.velocity.v);
  limits.w_Me = three(problem.velocity.w);
  return limits;
}

void apply_force(const ForceProblem& problem, const Eigen::Vector3d& foot_Me, Element& element) {
  const Eigen::Vector3d& n = element.normal_Me;
  const bool master_E = element.master == Side::E;
  const double shift = master_E ? problem.stiffness.shift_from_E : problem.stiffness.shift_from_F;
  element.position_Me = foot_Me + (shift * element.penetration) * n;  // (13)
  Eigen::Vector3d slip_Me = Eigen::Vector3d::Zero();
  if (problem.with_velocities) {
    // (17): velocity of the slave at C_k seen from the master, so that along n_k it approaches.
    const Eigen::Vector3d lever = element.position_Me - problem.pose.r;
    const Eigen::Vector3d v_F = problem.velocity.v + problem.velocity.w.cross(lever);
    const Eigen::Vector3d v_k = master_E ? v_F : Eigen::Vector3d(-v_F);
    element.normal_velocity = n.dot(v_k);  // (16)
    slip_Me = v_k - element.normal_velocity * n;
    element.tangential_velocity = length(slip_Me);  // (19)
  }
  const ElementForce force = element_force(problem.law, problem.stiffness.c_l, element.area, element.penetration,
                                           element.normal_velocity, element.tangential_velocity);
  element.normal_force = force.normal;
  element.tangential_force = force.tangential;
  Eigen::Vector3d on_master = force.normal * n;  // (21)
  if (element.tangential_velocity > 0) on_master += force.tangential * (slip_Me / element.tangential_velocity);
  element.force_Me = master_E ? on_master : Eigen::Vector3d(-on_master);
}

}  // namespace pcm::fast
