// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <SimTKmath.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "simulate/integrators/equation_system.h"
#include "simulate/integrators/solution_point.h"
#include "simulate/integrators/solver.h"

namespace pcm::simulate {

namespace {

/// Simbody tries a step again, smaller, on any exception.
struct Refused : std::exception {};

/// To meet an end, a Simbody step is made greater than what it was bounded to by at most this factor.
constexpr double kStretch = 1.001;
/// The first try, as a part of the way to the end asked for: each further step may be five times as great.
constexpr double kFirstStep = 1e-3;

class RungeKuttaMerson final : public Solver {
 public:
  RungeKuttaMerson(CountedEquation& equation, const StepControl& control, double t, const Eigen::VectorXd& y)
      : equation_(equation),
        control_(control),
        system_(static_cast<int>(y.size()),
                [this](double at, const SimTK::Vector& state) -> const SimTK::Vector& { return slope(at, state); }),
        integrator_(system_),
        end_{t, y, Eigen::VectorXd::Zero(y.size())},
        asked_y_(static_cast<int>(y.size()), 0.0),
        dydt_(static_cast<int>(y.size()), 0.0) {
    integrator_.setAccuracy(control.relative);
    integrator_.setAllowInterpolation(false);  // steps end at the ends asked for
    integrator_.setReturnEveryInternalStep(true);
    if (std::isfinite(control.greatest_step)) integrator_.setMaximumStepSize(control.greatest_step / kStretch);
  }

  Outcome step(double t_end, double least_step, double& t, Eigen::VectorXd& y) override {
    if (is_finer_than_rounding()) return Outcome::tolerances_too_fine;
    least_step_ = least_step;
    try {
      if (!is_initialized_) initialize(t_end);
      begin_ = {t, y, slope_asked_last()};
      integrator_.stepTo(t_end);
    } catch (const std::exception&) {
      return equation_.refused_last() ? Outcome::refused : Outcome::error_test;
    }
    const SimTK::Vector& z = integrator_.getAdvancedState().getZ();
    t = integrator_.getAdvancedTime();
    y = Eigen::Map<const Eigen::VectorXd>(&z[0], z.size());
    end_ = {t, y, slope_asked_last()};
    return Outcome::accepted;
  }

  bool interpolate(double t, Eigen::VectorXd& y) override {
    y = cubic_between(begin_, end_, t);
    return true;
  }

  /// Simbody counts a refused try both as one that did not converge and as one that failed the error test.
  Counts counts() const override {
    if (!is_initialized_) return {};
    return {integrator_.getNumErrorTestFailures() - integrator_.getNumConvergenceTestFailures(), 0, 0};
  }

  int order() const override { return integrator_.getMethodMaxOrder(); }

  std::string message() const override { return ""; }

 private:
  void initialize(double t_end) {
    const auto size = static_cast<int>(end_.y.size());
    integrator_.setInitialStepSize(std::max(kFirstStep * (t_end - end_.t), least_step_));
    SimTK::State state = system_.state_at(end_.t, SimTK::Vector(size, end_.y.data()));
    // Errors are measured in the greater of 1 / weight and |y_i|, times the relative tolerance.
    for (int i = 0; i < size; ++i) state.updZWeights()[i] = control_.relative / control_.absolute[i];
    integrator_.initialize(state);
    is_initialized_ = true;
    integrator_.stepTo(t_end);  // Simbody returns the start first
  }

  /// As CVODE has it: half an ulp in every component would be an error too large.
  bool is_finer_than_rounding() const {
    constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
    const Eigen::ArrayXd y = end_.y.array().abs();
    return std::sqrt((kUnit * y / (control_.relative * y).max(control_.absolute.array())).square().mean()) > 1;
  }

  Eigen::VectorXd slope_asked_last() const { return Eigen::Map<const Eigen::VectorXd>(&dydt_[0], dydt_.size()); }

  /// f, remembered, since Simbody asks for every state twice. The last one before a step ends is that of its end.
  const SimTK::Vector& slope(double t, const SimTK::Vector& y) {
    if (is_asked_ && t == asked_t_ && (y - asked_y_).normInf() == 0) return dydt_;
    // Simbody's own least step would be accepted whatever its error. Without one it makes steps smaller until they
    // vanish in t, and then throws; below our least step, or once the equation has thrown, each of these tries ends
    // here.
    if (is_stopped_ || is_below_least_step()) throw Refused();
    if (equation_.refused_last()) equation_.next_try();
    is_asked_ = false;
    const Answer answer = equation_.derivative(t, &y[0], &dydt_[0]);
    is_stopped_ = answer == Answer::stop;
    if (answer != Answer::given) throw Refused();
    asked_t_ = t;
    asked_y_ = y;
    is_asked_ = true;
    return dydt_;
  }

  bool is_below_least_step() const {
    return is_initialized_ && kStretch * integrator_.getPredictedNextStepSize() < least_step_;
  }

  CountedEquation& equation_;
  StepControl control_;
  EquationSystem system_;
  SimTK::RungeKuttaMersonIntegrator integrator_;
  bool is_initialized_ = false;
  double least_step_ = 0;
  SolutionPoint begin_, end_;  ///< of the last step
  bool is_asked_ = false, is_stopped_ = false;
  double asked_t_ = 0;
  SimTK::Vector asked_y_, dydt_;
};

}  // namespace

std::unique_ptr<Solver> make_runge_kutta_merson(CountedEquation& equation, const StepControl& control, double t,
                                                const Eigen::VectorXd& y) {
  return std::make_unique<RungeKuttaMerson>(equation, control, t, y);
}

}  // namespace pcm::simulate
