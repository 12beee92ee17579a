// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/law_error.h"

#include <algorithm>
#include <cmath>

#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

namespace {

constexpr double u = kUnitRoundoff;

/// The layers' stiffness (12) carries up to 3 roundings; given c_l or a rigid body it is exact.
constexpr double kStiffnessRoundings = 3;

// With V = A u: faded, A is min(A, V / u_d), which is off by no more than the greater of both errors.
Uncertain faded_area(const ContactLaw& law, const Uncertain& area, const Uncertain& depth, double volume_error) {
  if (law.transition_depth == 0 || depth.size - 2 * depth.error >= law.transition_depth) return area;
  const Uncertain fade{std::min(1.0, depth.size / law.transition_depth),
                       std::min(1.0, depth.error / law.transition_depth)};
  return {area.size * fade.size, std::min(area.error * std::min(1.0, fade.greatest()) + area.size * fade.error,
                                          std::max(area.error, volume_error / law.transition_depth))};
}

// What is damped: |v_n|, or in the mode `compression` max(v_n, 0), which a body that surely parts has exactly. No
// factor that is taken later widens an error of 0: so what the error itself is rounded by is paid for here.
Uncertain damped_velocity(const ContactLaw& law, double v_n, double v_n_error) {
  if (law.damping_mode != DampingMode::compression || v_n >= 0) return {std::abs(v_n), v_n_error};
  return {0, std::max(v_n + kSafetyFactor * v_n_error, 0.0)};
}

}  // namespace

// (14), (15), (18), the last a maximum, which never widens an error. Where the sum before it is surely negative, by
// twice the error, for it is worked out here with roundings of its own, F_n is 0 exactly.
Uncertain normal_force_error(const ForceProblem& problem, const Element& element, const ElementError& error,
                             double v_n_error) {
  const ContactLaw& law = problem.law;
  const Uncertain area{element.area, error.area}, depth{element.penetration, error.penetration};
  const double c_l = problem.stiffness.c_l;
  const double volume_error = error.volume;
  const double elastic = (c_l * area.size + kUnderflow) * depth.size;
  const double greatest_volume =
      std::min(area.greatest() * depth.greatest(), area.size * depth.size * kSafetyFactor + volume_error);
  const double elastic_error = c_l * std::min(volume_error, area.size * depth.error + area.error * depth.greatest()) +
                               (kStiffnessRoundings + 2) * u * c_l * greatest_volume +
                               (kUnderflow * (1 + area.greatest())) * depth.greatest() + kUnderflow;
  double damping = 0, damping_error = 0;
  if (law.damping > 0) {
    const Uncertain v_n = damped_velocity(law, element.normal_velocity, v_n_error);
    const Uncertain faded = faded_area(law, area, depth, volume_error);
    damping = (law.damping * faded.size) * v_n.size;
    damping_error = (law.damping * faded.error) * v_n.greatest() + (law.damping * faded.size) * v_n.error +
                    (5 * u * law.damping * faded.greatest()) * v_n.greatest() +
                    kUnderflow * (v_n.greatest() + law.damping * (1 + area.greatest()) * v_n.greatest()) + kUnderflow;
  }
  const double force_error = elastic_error + damping_error + u * (elastic + damping);
  const bool pulls = law.damping_mode == DampingMode::no_tension && element.normal_velocity < 0 &&
                     elastic - damping < -2 * force_error;
  return {std::abs(element.normal_force), pulls ? 0 : force_error};
}

// Friction (20), (21) as one vector: T = mu P h(s), P = max(F_n, 0), h(s) = phi(|s|) s / |s|, |h| <= 1, phi(v) = 1 from
// v_eps on and (v / v_eps)(2 - v / v_eps) below. The direction s / |s| alone has no bound near s = 0, but h has: its
// derivative is phi' along s and phi / v across, phi' <= phi / v, and phi / v falls with v. On the way from the
// computed s to the true one no |s| is less than v_low = |s| - |ds|, so |dh| <= min(2, |ds| phi(v_low) / v_low). At
// v_eps = 0 that is 1 / v_low, and 2 where s may vanish: the force jumps there. Roundings: |s| has 4 u, v / v_eps, its
// complement to 2 and their products 5, the direction and its product with F_t 3, mu P 2; doubled by s / v_eps entering
// twice: 24 u of |T| covers them.
FrictionErrors friction_error(const ContactLaw& law, const Uncertain& F_n, double v_t, double slip_error) {
  const double slip = law.slip_velocity;
  const double phi = v_t >= slip ? 1 : std::min(1.0, (v_t / slip) * (2 - v_t / slip) * kSafetyFactor);
  double turn = 0;
  if (slip_error > 0) {
    const double v_low = std::max(v_t - 2 * slip_error, 0.0);
    const double steepness = v_low < slip ? (2 - v_low / slip) / slip : 1 / v_low;
    turn = std::min(2.0, slip_error * steepness);
  }
  return {law.friction * F_n.error * phi, law.friction * F_n.greatest() * (turn + 24 * u * phi + kUnderflow)};
}

double greatest_normal_force(const ForceProblem& problem, double area, double u_k, double speed) {
  const ContactLaw& law = problem.law;
  double F_n = (problem.stiffness.c_l * area + kUnderflow) * u_k + kUnderflow;
  if (law.damping > 0) {
    const double fade = u_k < law.transition_depth ? u_k / law.transition_depth : 1;
    F_n += (law.damping * area + kUnderflow) * speed * fade + kUnderflow;
  }
  return F_n;
}

std::optional<NormalRates> surely_linear_rates(const ForceProblem& problem, const Element& element,
                                               const ElementError& error) {
  const ContactLaw& law = problem.law;
  const double c_l = problem.stiffness.c_l;
  const double depth = error.mean, volume = element.area * depth;
  if (!(error.passed_area + error.area < kGreatestShare * element.area)) return {};
  if (!(error.passed_volume + error.volume < kGreatestShare * volume)) return {};
  NormalRates rates{c_l, 0};
  if (law.damping == 0) return rates;
  const double v_n =
      law.damping_mode == DampingMode::compression ? std::max(element.normal_velocity, 0.0) : element.normal_velocity;
  double fade = 1;
  if (depth + error.penetration < law.transition_depth) {
    fade = depth / law.transition_depth;
    rates.per_volume += law.damping * v_n / law.transition_depth;
  } else if (depth - error.penetration > law.transition_depth) {
    rates.per_area += law.damping * v_n;
  } else {
    return {};
  }
  const double lever = (element.position_Me - problem.pose.r).lpNorm<1>();
  const double turning = problem.velocity.w.lpNorm<1>();
  const double speed = problem.velocity.v.lpNorm<1>() + turning * lever;
  const double velocity_error =
      turning * (error.foot_Me.sum() + error.penetration + depth * error.normal) + speed * (error.normal + 0x1p-40);
  const double force_error = (c_l + law.damping * fade * speed / depth) * (error.passed_volume + error.volume) +
                             (c_l * element.penetration + law.damping * speed) * (error.passed_area + error.area) +
                             law.damping * 2 * element.area * velocity_error +
                             0x1p-40 * (c_l * volume + law.damping * speed * element.area);
  const double force = c_l * element.area * element.penetration + law.damping * v_n * fade * element.area;
  if (!(std::abs(force) > 2 * force_error)) return {};
  if (force < 0 && law.damping_mode != DampingMode::full) return NormalRates{0, 0};
  return rates;
}

}  // namespace pcm::fast
