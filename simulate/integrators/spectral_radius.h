// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <utility>

#include "simulate/integrators/counted_equation.h"
#include "simulate/integrators/one_step.h"

namespace pcm::simulate {

/// The greatest absolute value of df/dy's eigenvalues, 1/s, by the power method with differences of f in place of
/// products J v; each estimate begins near the direction that the last one ended with.
class SpectralRadius {
 public:
  explicit SpectralRadius(Eigen::VectorXd absolute_tolerances) : absolute_(std::move(absolute_tolerances)) {}

  /// Asks for some derivatives beside the point. Where they can't be had the last estimate stays.
  Answer estimate(CountedEquation& equation, const SolutionPoint& at);
  /// With a margin for what the iteration has not reached.
  double value() const { return value_; }

 private:
  Eigen::VectorXd absolute_;
  Eigen::VectorXd direction_;
  double value_ = 0;
};

}  // namespace pcm::simulate
