// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/repartition_error.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fast/bounds/law_error.h"
#include "fast/posed/vertex_rounding.h"

namespace pcm::fast {

void RepartitionError::add(const ForceProblem& problem, const Element& element, ElementError& error,
                           ElementForceError& sum) {
  if (!(error.passed_area > 0)) return;
  const std::optional<NormalRates> normal = surely_linear_rates(problem, element, error);
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
