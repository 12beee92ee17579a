// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/element_law.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pcm::compare {

double series_stiffness(const ContactLaw& law) {
  if (!law.layers) return law.stiffness;
  const auto [c_E, c_F] = *law.layers;
  if (std::isinf(c_E)) return c_F;
  if (std::isinf(c_F)) return c_E;
  return c_E * (c_F / (c_E + c_F));
}

double share_of_penetration(const ContactLaw& law, Side master) {
  if (!law.layers) return 0.5;
  const double own = master == Side::E ? law.layers->c_E : law.layers->c_F;
  const double slave = master == Side::E ? law.layers->c_F : law.layers->c_E;
  if (std::isinf(own)) return 0;
  return std::isinf(slave) ? 1 : 1 / (1 + own / slave);
}

reference::Element after_law(const Question& question, reference::Element element) {
  const ContactLaw& law = question.law;
  const Velocity& velocity = question.velocity;
  const double sign = element.master == Side::E ? 1 : -1;
  const Eigen::Vector3d& n = element.normal_Me;
  const Eigen::Vector3d v_k = sign * (velocity.v + velocity.w.cross(element.position_Me - question.pose.r));
  element.normal_velocity = n.dot(v_k);
  const Eigen::Vector3d slip = v_k - element.normal_velocity * n;
  const double v_t = element.tangential_velocity = slip.stableNorm();

  const double elastic = series_stiffness(law) * element.area * element.penetration;
  double damping = law.damping * element.area * element.normal_velocity;
  if (element.penetration < law.transition_depth) damping *= element.penetration / law.transition_depth;
  if (law.damping_mode == DampingMode::compression) damping = std::max(damping, 0.0);
  element.normal_force = elastic + damping;
  if (law.damping_mode != DampingMode::full) element.normal_force = std::max(element.normal_force, 0.0);

  const double greatest = law.friction * std::max(element.normal_force, 0.0);
  const double t = v_t < law.slip_velocity ? v_t / law.slip_velocity : v_t > 0 ? 1 : 0;
  element.tangential_force = greatest * (t * (2 - t));
  Eigen::Vector3d on_master = element.normal_force * n;
  if (v_t > 0) on_master += element.tangential_force * (slip / v_t);
  element.force_Me = sign * on_master;
  return element;
}

}  // namespace pcm::compare
