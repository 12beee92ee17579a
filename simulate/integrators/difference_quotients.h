// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

#include "simulate/integrators/integrator.h"

namespace pcm::simulate {

/// By how much y_i is changed for column i of a difference quotient: sqrt(eps) |y_i|, at which rounding and curvature
/// weigh alike if y_i is of the size over which f varies, and where that is less, a tenth of the absolute tolerance.
///
/// A change below the tolerance means nothing to the step control, so the quotient is a tangent on the scale that
/// counts: kinks and regularisations wider than the tolerance are resolved. Relative tolerances don't enter; they would
/// widen the change of a fast body's velocity beyond the slip velocity of its contacts. Exactly representable:
/// (y_i + change) - y_i is the change.
double difference_increment(double y_i, double absolute_i);

/// J = df/dy at (t, y) by forward differences, backward in columns whose state ahead is `not_here`; `not_here` if that
/// one isn't either. `dydt` is f(t, y).
Evaluation difference_quotients(
    const std::function<Evaluation(double, const Eigen::VectorXd&, Eigen::VectorXd&)>& derivative,
    const Eigen::VectorXd& absolute, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& dydt,
    Eigen::MatrixXd& J);

}  // namespace pcm::simulate
