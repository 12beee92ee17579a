// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/contact_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fast/force_bound.h"
#include "fast/geometry.h"
#include "meshes/bad_input.h"

namespace pcm::fast {

ForceProblem force_problem(Scheme scheme, const ContactLaw& law, const Pose& pose, const Velocity& velocity,
                           const Wanted& wanted, StatisticsSum& statistics) {
  ForceProblem problem{scheme, law, SeriesStiffness(law), pose, velocity};
  problem.keep_elements = wanted.elements;
  problem.with_bound = wanted.bound;
  if (wanted.elements || wanted.statistics) problem.statistics = &statistics;
  problem.with_velocities = law.damping != 0 || law.friction != 0 || problem.statistics != nullptr;
  return problem;
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

void compute_force(Workspace::Data& workspace, Mode mode, const ForceProblem& problem) {
  Contact& contact = workspace.contact;
  std::optional<MasterBound> bounds[2];
  const auto total_of = [&](Side master) {
    if (!problem.with_bound) return sum_elements(workspace, master, problem);
    return sum_elements(workspace, master, problem,
                        &bounds[static_cast<std::size_t>(master)].emplace(workspace, master, problem));
  };
  if (mode == Mode::both) {
    const MasterForce on_E = total_of(Side::E);
    const MasterForce on_F = total_of(Side::F);
    contact.force_Me = 0.5 * (on_E.force_Me + on_F.force_Me);
    contact.torque_Me = 0.5 * (on_E.torque_Me + on_F.torque_Me);
    if (problem.with_bound) contact.bound = mean_bound(*bounds[0], *bounds[1], contact);
  } else {
    const Side master = mode == Mode::E ? Side::E : Side::F;
    const MasterForce total = total_of(master);
    contact.force_Me = total.force_Me;
    contact.torque_Me = total.torque_Me;
    if (problem.with_bound) contact.bound = bounds[static_cast<std::size_t>(master)]->result();
  }
  if (problem.statistics != nullptr) contact.statistics = problem.statistics->result();
}

void require_finite_force(const Contact& contact) {
  if (contact.force_Me.allFinite() && contact.torque_Me.allFinite()) return;
  throw BadInput("force or torque exceeds the range of doubles; choose units in which the numbers are smaller");
}

void form_elements_of_slave(Workspace::Data& workspace, Mode mode, const ForceProblem& problem) {
  if (mode == Mode::both) return;
  ForceProblem unheard = problem;
  unheard.with_bound = false;
  unheard.statistics = nullptr;
  sum_elements(workspace, mode == Mode::E ? Side::F : Side::E, unheard);
  Contact& contact = workspace.contact;
  contact.elements.clear();
  contact.element_count = contact.too_deep = 0;
  contact.max_penetration = 0;
  contact.penetration_exceeded = false;
}

}  // namespace pcm::fast
