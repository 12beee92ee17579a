// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/repartition_error.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

namespace {

/// What passes is less than this share of an element, or it counts in full.
constexpr double kGreatestShare = 0x1p-12;

/// Roundings of an element's rates, of themselves: those of the stiffness (3), or of the damping's product and quotient
/// with the transition depth (2), the sum of both 1, the direction's quotient 1, the product with it 1. Where terms
/// cancel, in that sum or between normal force and friction, roundings are greater than that, but no greater than the
/// element's own force has them of as great terms (force_error); of that force less than kGreatestShare passes, so they
/// are less than that share of its error, and within kGrowth. The lever's single rounding is less. Rates and lever of
/// the first element have none: the sums are off by no more whichever constants are taken from all rates and levers.
constexpr double kRateRoundings = 6;

/// dF_n / dV and dF_n / dA at fixed velocities, where F_n is surely linear, in both problems and between them.
struct NormalRates {
  double per_volume, per_area;
};
std::optional<NormalRates> surely_linear(const ForceProblem& problem, const Element& element,
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

}  // namespace

void RepartitionError::add(const ForceProblem& problem, const Element& element, ElementError& error,
                           ElementForceError& sum) {
  if (!(error.passed_area > 0)) return;
  const std::optional<NormalRates> normal = surely_linear(problem, element, error);
  if (!normal) {
    error.area += error.passed_area;
    error.volume += error.passed_volume;
    add_elsewhere(error.passed_area, error.passed_volume);
    return;
  }
  Rates rates;
  if (element.normal_force != 0) {
    const Eigen::Vector3d direction_Me = element.force_Me / element.normal_force;
    rates.per_volume_Me = normal->per_volume * direction_Me;
    rates.per_area_Me = normal->per_area * direction_Me;
  }
  rates.lever_Me = element.position_Me - problem.pose.r;
  if (!has_first_) {
    first_ = rates;
    has_first_ = true;
  }
  // Differences may be 0.
  constexpr double k = kRateRoundings * kUnitRoundoff;
  const auto cost = [&](const Eigen::Vector3d& mine, const Eigen::Vector3d& firsts, double passed) {
    const Eigen::Vector3d difference = passed * ((mine - firsts).cwiseAbs() + k * mine.cwiseAbs());
    sum.force_Me += difference;
    // L x c - L_1 x c_1 = L_1 x (c - c_1) + (L - L_1) x c, by lengths.
    const double torque =
        first_.lever_Me.lpNorm<1>() * difference.sum() +
        passed * ((rates.lever_Me - first_.lever_Me).lpNorm<1>() + k * rates.lever_Me.lpNorm<1>()) * mine.lpNorm<1>();
    sum.torque_Me += Eigen::Vector3d::Constant(torque);
  };
  cost(rates.per_volume_Me, first_.per_volume_Me, kSafetyFactor * error.passed_volume);
  cost(rates.per_area_Me, first_.per_area_Me, kSafetyFactor * error.passed_area);
}

void RepartitionError::add_elsewhere(double area, double volume) {
  elsewhere_area_ += area;
  elsewhere_volume_ += volume;
}

void RepartitionError::finish(ElementForceError& sum) const {
  if (!has_first_) return;
  const Eigen::Vector3d force_Me = RepartitionError::kGrowth * (elsewhere_volume_ * first_.per_volume_Me.cwiseAbs() +
                                                                elsewhere_area_ * first_.per_area_Me.cwiseAbs());
  sum.force_Me += force_Me;
  sum.torque_Me += Eigen::Vector3d::Constant(RepartitionError::kGrowth * first_.lever_Me.lpNorm<1>() * force_Me.sum());
}

}  // namespace pcm::fast
