// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/element_law.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "compare/verify/bounds/bound_arithmetic.h"

namespace pcm::compare {
namespace {

using roundoff::u;

/// Part of F_t / (mu F_n), t (2 - t) with t = v_t / v_eps below 1 and 1 from there on, that an error of v_t may change:
/// Lipschitz with 2 / v_eps; without v_eps a step at rest.
double friction_share_error(double slip_velocity, double v_t, double v_t_error) {
  if (slip_velocity > 0) return std::min(1.0, 2 * v_t_error / slip_velocity + 4 * u);
  return v_t > v_t_error || v_t_error == 0 ? 0 : 1;
}

void scale(double factor, ElementBounds& bounds) {
  for (double* bound :
       {&bounds.area, &bounds.penetration, &bounds.depth, &bounds.position, &bounds.normal, &bounds.normal_velocity,
        &bounds.tangential_velocity, &bounds.normal_force, &bounds.tangential_force, &bounds.force, &bounds.torque})
    *bound *= factor;
}

}  // namespace

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

LawSlopes law_slopes(const ContactLaw& law, const UncertainNumber& area, const UncertainNumber& penetration,
                     const UncertainNumber& v_n, const UncertainNumber& v_t) {
  using Number = UncertainNumber;
  const Number zero, one(1), two(2), u_d(law.transition_depth), mu(law.friction), v_eps(law.slip_velocity);
  const double c_l = series_stiffness(law);
  const Number stiffness = Number(c_l, 4 * u * c_l) * area, viscosity = Number(law.damping) * area;

  // F_d (15) and its derivatives, by depth and by approach.
  Number damping = viscosity * v_n, damping_by_depth, damping_by_approach = viscosity;
  if (law.transition_depth > 0) {
    const auto fading = [&](const Number& faded, const Number& whole) {
      return where_below(penetration, law.transition_depth, faded, whole);
    };
    damping_by_depth = fading(damping / u_d, zero);
    damping_by_approach = fading(viscosity * (penetration / u_d), viscosity);
    damping = fading(damping * (penetration / u_d), damping);
  }
  if (law.damping_mode == DampingMode::compression) {
    for (Number* x : {&damping, &damping_by_depth, &damping_by_approach}) *x = where_below(v_n, 0, zero, *x);
  }

  // (18): what pulls is cut off, and nothing of it rubs.
  const Number force = stiffness * penetration + damping;
  const Number by_depth = stiffness + damping_by_depth, by_approach = damping_by_approach;
  const auto pressing = [&](const Number& x) { return where_below(force, 0, zero, x); };
  const bool full = law.damping_mode == DampingMode::full;

  // (20): the shares of mu F_n that F_t is, and that its derivative by v_t and F_t / v_t are.
  const Number limit = mu * pressing(force);
  Number share = one, by_slip, over_slip;
  if (v_t.is_zero() && law.slip_velocity == 0) {
    share = zero;
  } else {
    over_slip = limit / v_t;
    if (law.slip_velocity == 0 && !v_t.surely_from(0)) share = hull(zero, one);
  }
  if (law.slip_velocity > 0) {
    const Number slip = v_t / v_eps;
    const auto sticking = [&](const Number& sticks, const Number& slides) {
      return where_below(v_t, law.slip_velocity, sticks, slides);
    };
    share = sticking(slip * (two - slip), one);
    by_slip = sticking(limit * ((two - two * slip) / v_eps), zero);
    over_slip = sticking(limit * ((two - slip) / v_eps), over_slip);
  }
  return {full ? by_depth : pressing(by_depth),
          full ? by_approach : pressing(by_approach),
          mu * pressing(by_depth) * share,
          mu * pressing(by_approach) * share,
          by_slip,
          over_slip};
}

double greatest_force(const ContactLaw& law, double area, double penetration, double speed) {
  return (1 + law.friction) * area * (series_stiffness(law) * penetration + law.damping * speed);
}

ElementBounds bounds_after_law(const Question& question, const reference::Element& truth,
                               const GeometryErrors& errors) {
  const ContactLaw& law = question.law;
  ElementBounds bounds;
  bounds.area = errors.area;
  bounds.normal = errors.normal + 4 * u;
  // Clamping to max_penetration magnifies no error, and leaves none greater than what it clamps to.
  bounds.depth = errors.penetration;
  bounds.penetration = std::min(errors.penetration, law.max_penetration);
  // A whole element that is deeper than that for certain has that penetration.
  const bool clamped = question.scheme == Scheme::barycentric &&
                       truth.greatest_penetration - kHigherOrder * errors.penetration > law.max_penetration;
  if (clamped) bounds.penetration = 0;
  const double most_area = truth.area + bounds.area, most_penetration = truth.penetration + bounds.penetration;

  // Position (13), C_k = C + w u_k n_k, 0 <= w <= 1.
  bounds.position = errors.foot + bounds.penetration + truth.penetration * bounds.normal +
                    std::sqrt(3.0) * u * (2 * truth.position_Me.cwiseAbs().maxCoeff());

  // Velocity (17), v_k = v + w x (C_k - r), and its parts (16), (19).
  const Eigen::Vector3d arm = truth.position_Me - question.pose.r;
  const Velocity& velocity = question.velocity;
  const double speed = (velocity.v + velocity.w.cross(arm)).stableNorm();
  const double arm_error = bounds.position + 2 * u * arm.stableNorm();
  const double velocity_error = times(velocity.w.stableNorm(), arm_error + 6 * u * arm.stableNorm()) +
                                2 * u * (velocity.v.stableNorm() + velocity.w.stableNorm() * arm.stableNorm());
  bounds.normal_velocity = velocity_error + speed * bounds.normal;
  bounds.tangential_velocity = velocity_error + 2 * speed * (bounds.normal + 2 * u);

  // Normal force: F_c = c_l A u_k (14); F_d = d_l A v_n fade (15), fade = min(1, u_k / u_d) is Lipschitz with 1 / u_d;
  // what damping may do to F_n (18) never magnifies an error. c_l (12) has 3 roundings.
  const double c_l = series_stiffness(law);
  const double elastic = c_l * times(most_area, most_penetration);
  const double volume_error =
      std::min(errors.volume, times(bounds.area, truth.penetration) + times(most_area, bounds.penetration));
  const double elastic_error = c_l * volume_error + 6 * u * elastic;
  const double v_n = std::abs(truth.normal_velocity), most_v_n = v_n + bounds.normal_velocity;
  const double fade = law.transition_depth > 0 ? std::min(1.0, truth.penetration / law.transition_depth) : 1;
  const double fade_error = law.transition_depth > 0 && truth.penetration < law.transition_depth + bounds.penetration
                                ? std::min(1.0, bounds.penetration / law.transition_depth + u)
                                : 0;
  const double damping = times(law.damping, times(most_area, most_v_n));
  double damping_error =
      times(law.damping, times(times(bounds.area, v_n) + times(most_area, bounds.normal_velocity), fade)) +
      times(damping, fade_error + 4 * u);
  const bool parts = truth.normal_velocity < -kHigherOrder * bounds.normal_velocity;
  if (law.damping_mode == DampingMode::compression && parts) damping_error = 0;
  bounds.normal_force = elastic_error + damping_error;
  bounds.normal_force += u * (std::abs(truth.normal_force) + bounds.normal_force);
  // Where damping pulls harder than the foundation pushes, for certain, F_n is 0 whatever the errors.
  const double pull = law.damping * truth.area * v_n * fade - c_l * truth.area * truth.penetration;
  if (law.damping_mode == DampingMode::no_tension && parts && pull > kHigherOrder * bounds.normal_force)
    bounds.normal_force = 0;
  const double normal_force = std::abs(truth.normal_force) + bounds.normal_force;  // an upper bound of |F_n|

  // Friction (20), (21): mu F_n g with g = t (2 - t) v_T / v_t, t = min(1, v_t / v_eps). |g| <= 1, and g is Lipschitz
  // with 2 / max(v_eps, v_t): twice 1 / v_t where it is a unit vector, 2 / v_eps at rest.
  const double v_t = truth.tangential_velocity, v_t_error = bounds.tangential_velocity;
  const double slip = std::max(law.slip_velocity, v_t);
  const double direction_error = slip > 0 ? std::min(2.0, 2 * v_t_error / slip + 8 * u) : 2;
  const bool moves = v_t > 0 || v_t_error > 0;
  const double friction_error = moves ? times(law.friction, bounds.normal_force + normal_force * direction_error) : 0;
  const double share_error = friction_share_error(law.slip_velocity, v_t, v_t_error);
  bounds.tangential_force = moves ? times(law.friction, bounds.normal_force + normal_force * (share_error + 4 * u)) : 0;

  // F_k = F_n n_k + friction, M_k = (C_k - r) x F_k.
  const double magnitude = normal_force * (1 + law.friction);
  bounds.force = bounds.normal_force + normal_force * bounds.normal + friction_error + 3 * u * magnitude + kUnderflow;
  bounds.torque =
      times(arm.stableNorm(), bounds.force) + times(arm_error + 4 * u * arm.stableNorm(), magnitude) + kUnderflow;

  scale(kHigherOrder, bounds);
  return bounds;
}

ElementBounds twice(ElementBounds bounds) {
  scale(2, bounds);
  return bounds;
}

}  // namespace pcm::compare
