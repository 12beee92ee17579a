// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/step_size.h"

#include <algorithm>
#include <cmath>

namespace pcm::simulate {

namespace {

/// Aimed at is 0.8 of the size that just meets the tolerance; sizes change by a factor of ten at most.
constexpr double kSafety = 0.8, kLeastChange = 0.1, kGreatestChange = 10;
constexpr double kAfterRefusal = 0.25;

}  // namespace

double error_in_tolerances(const Eigen::VectorXd& error, const Eigen::VectorXd& y, double relative,
                           const Eigen::VectorXd& absolute) {
  const Eigen::ArrayXd tolerance = relative * y.array().abs() + absolute.array();
  return std::sqrt((error.array() / tolerance).square().mean());
}

double StepSizeControl::to_tolerance(double error) const {
  // The bound takes effect beyond the greatest change alone.
  return std::pow(std::max(error, 1e-12), -1.0 / error_power_);
}

double StepSizeControl::after_accepted(double size, double error) {
  double change = kSafety * to_tolerance(error);
  if (last_size_ > 0) {
    // As the error grew from the last step to this one, so it goes on to grow.
    const double trend = (size / last_size_) * to_tolerance(error) / to_tolerance(last_error_);
    change = std::min(change, change * trend);
  }
  last_size_ = size;
  last_error_ = error;
  const double greatest = steps_without_growth_ > 0 ? 1 : kGreatestChange;
  if (steps_without_growth_ > 0) --steps_without_growth_;
  return std::clamp(change, kLeastChange, greatest);
}

double StepSizeControl::after_rejected(double error) const {
  return std::clamp(kSafety * to_tolerance(error), kLeastChange, kSafety);
}

double StepSizeControl::after_refused() {
  steps_without_growth_ = 2;
  return kAfterRefusal;
}

}  // namespace pcm::simulate
