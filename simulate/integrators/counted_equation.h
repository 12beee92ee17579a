// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <exception>
#include <optional>

#include "simulate/integrators/integrator.h"

namespace pcm::simulate {

/// What C callbacks answer to SUNDIALS; Simbody's get an exception for the last two.
enum class Answer : int { given = 0, try_smaller = 1, stop = -1 };

/// The equation as the solvers' callbacks see it: counted, without exceptions, on plain arrays.
class CountedEquation {
 public:
  CountedEquation(DifferentialEquation equation, Eigen::VectorXd absolute);

  Eigen::Index size() const { return equation_.size; }

  Answer derivative(double t, const double* y, double* dydt);

  /// f beside the solution, for differences: counted alike, but what can't be had there rejects no try.
  Answer derivative_beside(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt);

  /// J by columns, which must be zero or overwritable. `dydt` is f(t, y); where it is null, that of the last call of
  /// `derivative`, which must then have been at (t, y).
  Answer jacobian(double t, const double* y, const double* dydt, double* J);

  /// Throws what the equation has thrown, once.
  void rethrow();

  /// From here on a refusal belongs to another try than those before. SUNDIALS doesn't tell of its tries: within one,
  /// all refusals are at the same t (a nonlinear solver goes on once with a new Jacobian), and the next is at another.
  void next_try() { refused_at_.reset(); }

  /// Whether the last call of either function was answered by `try_smaller`.
  bool refused_last() const { return refused_last_; }
  /// Why, if it was: something was not finite, rather than not to be had.
  bool refused_last_not_finite() const { return refused_last_not_finite_; }

  std::int64_t derivatives() const { return derivatives_; }
  std::int64_t derivatives_for_jacobians() const { return derivatives_for_jacobians_; }
  std::int64_t linear_derivatives() const { return linear_derivatives_; }
  std::int64_t jacobians() const { return jacobians_; }
  std::int64_t tries_not_here() const { return tries_not_here_; }
  std::int64_t tries_not_finite() const { return tries_not_finite_; }

 private:
  template <typename Function>
  Answer guarded(const Function& function);
  Answer refuse(double t, std::int64_t& tries);
  Evaluation evaluate(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt, std::int64_t& calls) const;
  Evaluation differences(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& dydt);

  DifferentialEquation equation_;
  Eigen::VectorXd absolute_;
  double t_ = 0;              ///< of the last derivative
  Eigen::VectorXd y_, dydt_;  ///< the same
  Eigen::MatrixXd J_;
  std::optional<double> refused_at_;
  bool refused_last_ = false, refused_last_not_finite_ = false;
  std::exception_ptr thrown_;
  std::int64_t derivatives_ = 0, derivatives_for_jacobians_ = 0, linear_derivatives_ = 0, jacobians_ = 0;
  std::int64_t tries_not_here_ = 0, tries_not_finite_ = 0;
};

}  // namespace pcm::simulate
