// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace pcm::simulate {

/// The solution at t, with its slope f(t, y).
struct SolutionPoint {
  double t = 0;
  Eigen::VectorXd y, dydt;
};

/// At `t` on the cubic through states and slopes at both points (Hermite's), of order 3.
inline Eigen::VectorXd cubic_between(const SolutionPoint& begin, const SolutionPoint& end, double t) {
  const double h = end.t - begin.t, part = (t - begin.t) / h, rest = 1 - part;
  const Eigen::VectorXd change = end.y - begin.y;
  return begin.y + part * change + part * rest * (rest * (h * begin.dydt - change) - part * (h * end.dydt - change));
}

}  // namespace pcm::simulate
