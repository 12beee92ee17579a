// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

/// Ordinary differential equations with events, by CVODE of SUNDIALS (Adams formulas of variable order and step).
namespace pcm::compare {

/// dy/dt = derivative(t, y) until an event or a final time.
///
/// The integrator asks for derivatives and events a step beyond the event too, so `derivative` must be smooth across
/// it: continue the law that holds before the event, or order and error control are lost there.
struct InitialValueProblem {
  std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& y)> derivative;
  /// An event happens where its function rises through zero.
  std::vector<std::function<double(double t, const Eigen::VectorXd& y)>> events;
};

/// The error committed by one step is kept below sqrt(n) (relative |y_i| + absolute_i) in each of the n components:
/// CVODE bounds the root mean square of the weighted components by 1.
struct StepTolerance {
  double relative = 1e-8;
  Eigen::VectorXd absolute;
};

/// What an integration cost.
struct IntegrationWork {
  std::int64_t steps = 0;
  std::int64_t derivatives = 0;
};

/// Moves `t` and `y` to the first event, or to `t_end` if none happens before; adds to `work`. The number of the event
/// that happened, none at `t_end`. What `derivative` or an event throws comes out again; std::runtime_error where CVODE
/// gives up.
std::optional<std::size_t> integrate(const InitialValueProblem& problem, const StepTolerance& tolerance, double t_end,
                                     double& t, Eigen::VectorXd& y, IntegrationWork& work);

}  // namespace pcm::compare
