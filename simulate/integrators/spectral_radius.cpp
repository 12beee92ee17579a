// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/spectral_radius.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulate/integrators/difference_quotients.h"

namespace pcm::simulate {

namespace {

/// As in the program that goes with the paper (chebyshev_stages.h): enough when two estimates in a row differ by a
/// hundredth, and a fifth is added.
constexpr int kMostIterations = 50;
constexpr double kAgreement = 0.01, kMargin = 1.2;
/// Of all components in the direction that an estimate begins with, beside the last one's.
constexpr double kShare = 0.1;

}  // namespace

Answer SpectralRadius::estimate(CountedEquation& equation, const SolutionPoint& at) {
  // Directions are measured in the changes that difference quotients make, and so are neither lost in rounding nor
  // wider than the tolerances.
  Eigen::VectorXd changes(at.y.size());
  for (Eigen::Index i = 0; i < changes.size(); ++i) changes[i] = difference_increment(at.y[i], absolute_[i]);
  const auto length = [&](const Eigen::VectorXd& v) {
    return std::sqrt((v.array() / changes.array()).square().mean());
  };

  // Every component has a share, lest one that has turned stiff is missed.
  if (direction_.size() == 0) direction_ = at.dydt;
  direction_ = kShare * changes + direction_ / std::max(length(direction_), std::numeric_limits<double>::min());
  double radius = 0;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    Eigen::VectorXd beside = at.y + direction_ / length(direction_), slope(at.y.size());
    Answer answer = equation.derivative_beside(at.t, beside, slope);
    if (answer == Answer::try_smaller) {
      beside = at.y - direction_ / length(direction_);
      answer = equation.derivative_beside(at.t, beside, slope);
    }
    if (answer == Answer::try_smaller) return Answer::given;
    if (answer == Answer::stop) return answer;
    direction_ = slope - at.dydt;
    const double before = radius;
    radius = length(direction_) / length(beside - at.y);
    if (radius == 0 || (iteration > 0 && std::abs(radius - before) <= kAgreement * radius)) break;
  }
  value_ = kMargin * radius;
  return Answer::given;
}

}  // namespace pcm::simulate
