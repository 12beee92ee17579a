// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/make_integrator.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "pcm/bad_input.h"
#include "simulate/integrators/counted_equation.h"
#include "simulate/integrators/solver.h"

namespace pcm::simulate {

namespace {

std::string text(double number) {
  char digits[32];
  return {digits, std::to_chars(std::begin(digits), std::end(digits), number).ptr};
}

void expect(bool holds, Method method, const std::string& message) {
  if (!holds) throw BadInput("integrator " + std::string(name(method)) + ": " + message);
}

void check(Method method, const DifferentialEquation& equation, const StepControl& control) {
  expect(equation.size > 0, method, "the equation has no components");
  expect(static_cast<bool>(equation.derivative), method, "the equation has no derivative");
  expect(control.absolute.size() == equation.size, method,
         "there are " + std::to_string(control.absolute.size()) + " absolute tolerances for " +
             std::to_string(equation.size) + " components: one each");
  expect(control.relative > 0 && std::isfinite(control.relative), method,
         "the relative tolerance is " + text(control.relative) + ": it must be positive");
  expect(control.relative < 1 || method != Method::runge_kutta_merson, method,
         "the relative tolerance is " + text(control.relative) + ": Simbody takes those below 1 alone");
  for (Eigen::Index i = 0; i < equation.size; ++i) {
    expect(control.absolute[i] > 0 && std::isfinite(control.absolute[i]), method,
           "the absolute tolerance of component " + std::to_string(i) + " is " + text(control.absolute[i]) +
               ": it must be positive");
  }
  expect(control.least_step >= 0 && control.greatest_step > 0 && control.least_step <= control.greatest_step, method,
         "steps from " + text(control.least_step) + " s to " + text(control.greatest_step) +
             " s: the least must not be negative, nor above the greatest");
  expect(control.most_steps > 0, method, "at most " + std::to_string(control.most_steps) + " steps: allow some");
}

std::string cause_of(Outcome outcome, const CountedEquation& equation, const std::string& message) {
  switch (outcome) {
    case Outcome::error_test:
      return "the error of a step stays too large however small the step: loosen the tolerances, or allow smaller "
             "steps";
    case Outcome::nonlinear:
      return "the nonlinear iteration does not converge however small the step: allow smaller steps, or take an "
             "explicit method";
    case Outcome::refused:
      return equation.refused_last_not_finite()
                 ? "the state or its derivative is not finite however small the step: look at the equation there"
                 : "the derivative can't be had beyond here however small the step: stop before, or change what makes "
                   "it unavailable";
    case Outcome::tolerances_too_fine:
      return "the tolerances are finer than rounding of the state: loosen them";
    default:
      return "its library says: " + (message.empty() ? "nothing" : message);
  }
}

class SteppingIntegrator final : public Integrator {
 public:
  SteppingIntegrator(Method method, DifferentialEquation equation, StepControl control)
      : method_(method), equation_(std::move(equation), control.absolute), control_(std::move(control)) {}

  void start(double t, const Eigen::VectorXd& y) override {
    expect(std::isfinite(t), method_, "the start at t = " + text(t) + " s is not finite");
    expect(y.size() == equation_.size(), method_,
           "the initial state has " + std::to_string(y.size()) + " components, the equation " +
               std::to_string(equation_.size()));
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      expect(std::isfinite(y[i]), method_, "component " + std::to_string(i) + " of the initial state is not finite");
    }
    t_ = t;
    y_ = y;
    begin_ = t;
    solver_ = make_solver();
    counts_ = {};
    steps_ = 0;
  }

  Step step(double t_end) override {
    expect(solver_ != nullptr, method_, "there are no steps before a start, nor after a failure");
    expect(std::isfinite(t_end) && t_end > t_, method_,
           "a step from t = " + text(t_) + " s can't end at " + text(t_end) + " s: the end lies beyond the beginning");
    if (steps_ == control_.most_steps) {
      give_up(std::to_string(steps_) + " steps were taken: allow more, or loosen the tolerances");
    }
    equation_.next_try();
    const Failures before = work_.failures;
    double t = t_;
    Eigen::VectorXd y = y_;
    const Outcome outcome = solver_->step(t_end, least_step(t_end), t, y);
    count_work();
    rethrow();
    if (outcome != Outcome::accepted) give_up(cause_of(outcome, equation_, solver_->message()));
    if (!y.allFinite()) give_up("the state is not finite: loosen the tolerances, or take another method");
    if (t <= t_) give_up("steps are as small as rounding of t: loosen the tolerances");
    return accept(t, y, before);
  }

  double t() const override { return t_; }
  const Eigen::VectorXd& y() const override { return y_; }
  const Work& work() const override { return work_; }

  Eigen::VectorXd state_at(double t) const override {
    if (t == t_) return y_;
    Eigen::VectorXd y = y_;
    const bool is_within = solver_ && t >= begin_ && t < t_;
    expect(is_within && solver_->interpolate(t, y), method_,
           "the state at t = " + text(t) + " s is not to be had: the last step is " + text(begin_) + " s to " +
               text(t_) + " s");
    return y;
  }

 private:
  std::unique_ptr<Solver> make_solver() {
    switch (method_) {
      case Method::adams:
      case Method::bdf:
        return make_cvode(method_, equation_, control_, t_, y_);
      case Method::ida:
        return make_ida(equation_, control_, t_, y_);
      case Method::rkc:
        return make_rkc(equation_, control_, t_, y_);
      case Method::runge_kutta_merson:
        return make_runge_kutta_merson(equation_, control_, t_, y_);
      default:
        return make_arkode(method_, equation_, control_, t_, y_);
    }
  }

  /// Steps below this vanish in t; SUNDIALS itself would go on taking them.
  double least_step(double t_end) const {
    constexpr double kUlps = 16;
    const double of_rounding = kUlps * std::numeric_limits<double>::epsilon() * std::max(std::abs(t_), std::abs(t_end));
    return std::min(std::max(control_.least_step, of_rounding), control_.greatest_step);
  }

  Step accept(double t, const Eigen::VectorXd& y, const Failures& before) {
    ++steps_;
    ++work_.steps;
    begin_ = t_;
    t_ = t;
    y_ = y;
    const Failures& now = work_.failures;
    return {t_,
            t_ - begin_,
            solver_->order(),
            {now.error_test - before.error_test, now.nonlinear - before.nonlinear, now.not_here - before.not_here,
             now.not_finite - before.not_finite}};
  }

  void count_work() {
    const Solver::Counts counts = solver_->counts();
    const std::int64_t refused =
        equation_.tries_not_here() - work_.failures.not_here + equation_.tries_not_finite() - work_.failures.not_finite;
    work_.failures.error_test += counts.error_test_failures - counts_.error_test_failures;
    work_.failures.nonlinear += std::max<std::int64_t>(0, counts.solve_failures - counts_.solve_failures - refused);
    work_.failures.not_here = equation_.tries_not_here();
    work_.failures.not_finite = equation_.tries_not_finite();
    work_.nonlinear_iterations += counts.nonlinear_iterations - counts_.nonlinear_iterations;
    work_.derivatives = equation_.derivatives();
    work_.derivatives_for_jacobians = equation_.derivatives_for_jacobians();
    work_.linear_derivatives = equation_.linear_derivatives();
    work_.jacobians = equation_.jacobians();
    counts_ = counts;
  }

  void rethrow() {
    try {
      equation_.rethrow();
    } catch (...) {
      solver_.reset();
      throw;
    }
  }

  [[noreturn]] void give_up(const std::string& cause) {
    solver_.reset();
    throw IntegrationFailure(t_, std::string(name(method_)) + " gave up at t = " + text(t_) + " s: " + cause);
  }

  Method method_;
  CountedEquation equation_;
  StepControl control_;
  std::unique_ptr<Solver> solver_;  ///< none before a start and after a failure
  double begin_ = 0, t_ = 0;        ///< of the last step
  Eigen::VectorXd y_;
  Work work_;
  Solver::Counts counts_;   ///< what of the solver's counts is in work_
  std::int64_t steps_ = 0;  ///< since the start
};

}  // namespace

std::unique_ptr<Integrator> make_integrator(Method method, DifferentialEquation equation, StepControl control) {
  check(method, equation, control);
  return std::make_unique<SteppingIntegrator>(method, std::move(equation), std::move(control));
}

}  // namespace pcm::simulate
