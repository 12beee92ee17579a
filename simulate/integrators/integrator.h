// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

/// Ordinary differential equations, integrated step by step: by SUNDIALS, by Simbody and by a stabilised explicit
/// method. Times are in s. C++17, as Simbody's headers can't be read as C++20.
namespace pcm::simulate {

/// Whether a function could be had where it was asked for.
enum class Evaluation : std::uint8_t {
  available,
  /// The step that asked is tried again, smaller, and this is counted. Implicit methods don't ask at the very state
  /// they accept: it may lie, by less than the tolerance, where there is no derivative, and then there is no further
  /// step.
  not_here,
};

/// What difference quotients at a state ask in place of f.
struct Linearisation {
  /// f to first order about the state, without a refusal; where it is empty, f itself is asked.
  std::function<void(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt)> derivative;
  std::int64_t cost = 0;  ///< what it took to make it, in calls of `DifferentialEquation::derivative`
};

/// dy/dt = f(t, y).
///
/// Both functions may throw: the step is given up and `Integrator::step` throws the same exception. What is not finite
/// in an `available` answer is met like `not_here`, and counted apart.
struct DifferentialEquation {
  Eigen::Index size = 0;  ///< of y
  /// Fills `dydt`, which has the right size.
  std::function<Evaluation(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt)> derivative;
  /// Fills J = df/dy, of the right size; `dydt` is f(t, y). For implicit methods; where it is empty, difference
  /// quotients take a call of `derivative` for each column (difference_quotients.h).
  std::function<Evaluation(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& dydt, Eigen::MatrixXd& J)>
      jacobian;
  /// Called with y before its difference quotients, of which it may say what they ask: where f is dear, and f to first
  /// order is not. Where it is empty, f itself.
  std::function<Linearisation(double t, const Eigen::VectorXd& y)> linearise = {};
};

enum class Method : std::uint8_t {
  adams,           ///< CVODE: Adams formulas of order 1 to 12, fixed-point iteration
  bdf,             ///< CVODE: backward differentiation formulas of order 1 to 5, Newton's iteration
  ida,             ///< IDA: the same formulas with a fixed leading coefficient, y' - f(t, y) = 0 as its residual
  dormand_prince,  ///< ARKODE: explicit Runge-Kutta of order 5(4), 7 stages, as in DOPRI5
  esdirk,  ///< ARKODE: diagonally implicit Runge-Kutta of order 4(3), 6 stages, stiffly accurate (ESDIRK4(3)6L[2]SA)
  rkc,     ///< Runge-Kutta-Chebyshev, explicit, of order 2, stages by the spectral radius (chebyshev_stages.h)
  /// Simbody: explicit Runge-Kutta of order 4(3), 5 stages. Its errors are divided by the greater of relative |y_i| and
  /// absolute_i, where |y_i| is that at the step's beginning. Takes relative tolerances below 1 alone. Where a step
  /// fails, it is given up if the next try would be below the least step.
  runge_kutta_merson,
};
std::string_view name(Method method);

/// Whether it solves for its steps by Newton's iteration, with Jacobians.
inline bool takes_jacobians(Method method) {
  return method == Method::bdf || method == Method::ida || method == Method::esdirk;
}
/// What is said of one that does not, where Jacobians are asked for.
inline constexpr const char* kTakesNoJacobians = " takes none; leave it out, or choose bdf, ida or esdirk";

struct StepControl {
  /// The error committed by one step is kept below a root mean square of 1 over the components, each divided by
  /// relative |y_i| + absolute_i.
  double relative = 1e-6;
  Eigen::VectorXd absolute;
  double greatest_step = std::numeric_limits<double>::infinity();
  /// A step that fails at this size is given up; rounding of t sets a limit of its own, 16 ulp.
  double least_step = 0;
  std::int64_t most_steps = std::numeric_limits<std::int64_t>::max();  ///< from a start on
};

/// Tries of a step that were rejected, each to be tried again smaller, by cause.
struct Failures {
  std::int64_t error_test = 0;  ///< the estimated error was too large
  std::int64_t nonlinear = 0;   ///< Newton's or the fixed-point iteration did not converge
  std::int64_t not_here = 0;    ///< the derivative, or the Jacobian, could not be had
  std::int64_t not_finite = 0;  ///< a state, derivative or Jacobian was not finite
};

/// One accepted step.
struct Step {
  double t = 0;     ///< its end
  double size = 0;  ///< it began at t - size
  int order = 0;    ///< of the formula that took it
  Failures failures;
};

/// What was done since the integrator was made, over all its starts.
struct Work {
  std::int64_t steps = 0;                      ///< accepted ones
  std::int64_t derivatives = 0;                ///< calls of `derivative` but for those in the next line
  std::int64_t derivatives_for_jacobians = 0;  ///< calls of `derivative` for difference quotients, or their worth
  std::int64_t linear_derivatives = 0;         ///< calls of linearised ones for difference quotients, beside these
  std::int64_t jacobians = 0;                  ///< by difference quotients or calls of `jacobian`
  std::int64_t nonlinear_iterations = 0;
  Failures failures;  ///< those of steps that were given up included
};

/// The integrator gave up: the message has the method, the time, the cause, and what to change.
class IntegrationFailure : public std::runtime_error {
 public:
  IntegrationFailure(double t, const std::string& message) : std::runtime_error(message), t_(t) {}
  double t() const { return t_; }  ///< up to here the solution is there

 private:
  double t_;
};

/// Takes steps from a start on, never back. Input that is wrong is refused by BadInput.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Forgets what was before: all that follows, to the last bit, depends on (t, y) and on the ends of the steps asked
  /// for, so that what starts anew at fixed times can be interrupted there and continued. Calls no derivative.
  virtual void start(double t, const Eigen::VectorXd& y) = 0;

  /// One accepted step, which ends at `t_end` at the latest, and then at `t_end` exactly: an earlier `t_end` bounds
  /// this step alone. Outputs are no reason to stop, see `state_at`. The size of the first step after a start depends
  /// on `t_end` too (all methods try a fraction of the way to it). Throws IntegrationFailure, or what the equation
  /// throws; y() and t() stay, and there are no more steps before a `start`.
  virtual Step step(double t_end) = 0;

  virtual double t() const = 0;
  virtual const Eigen::VectorXd& y() const = 0;  ///< at t()

  /// The state within the last step by an interpolant that calls no derivative: of the order of the step in multistep
  /// methods, of order 4 in Dormand and Prince's (as in DOPRI5), and of order 3 in the others (the cubic through
  /// states and slopes at both ends of the step).
  virtual Eigen::VectorXd state_at(double t) const = 0;

  virtual const Work& work() const = 0;
};

}  // namespace pcm::simulate
