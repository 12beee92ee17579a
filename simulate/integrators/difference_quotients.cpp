// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/difference_quotients.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcm::simulate {

double difference_increment(double y_i, double absolute_i) {
  const double root_of_eps = std::sqrt(std::numeric_limits<double>::epsilon());
  const double change = std::max(root_of_eps * std::abs(y_i), 0.1 * absolute_i);
  return (y_i + change) - y_i;
}

Evaluation difference_quotients(
    const std::function<Evaluation(double, const Eigen::VectorXd&, Eigen::VectorXd&)>& derivative,
    const Eigen::VectorXd& absolute, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& dydt,
    Eigen::MatrixXd& J) {
  Eigen::VectorXd changed = y, slope(y.size());
  const auto is_refused = [&] { return derivative(t, changed, slope) == Evaluation::not_here || !slope.allFinite(); };
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    double change = difference_increment(y[i], absolute[i]);
    changed[i] = y[i] + change;
    if (is_refused()) {
      changed[i] = y[i] - change;
      change = changed[i] - y[i];
      if (is_refused()) return Evaluation::not_here;
    }
    J.col(i) = (slope - dydt) / change;
    changed[i] = y[i];
  }
  return Evaluation::available;
}

}  // namespace pcm::simulate
