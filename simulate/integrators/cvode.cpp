// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cvode/cvode.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cmath>

#include "simulate/integrators/solver.h"
#include "simulate/integrators/sundials_objects.h"

namespace pcm::simulate {

namespace {

void free_cvode(void* cvode) {
  CVodeFree(&cvode);
}

class Cvode final : public Solver {
 public:
  Cvode(Method method, CountedEquation& equation, const StepControl& control, double t, const Eigen::VectorXd& y)
      : callbacks_{equation, {}},
        state_(make_vector(y, context_)),
        absolute_(make_vector(control.absolute, context_)),
        memory_(CVodeCreate(method == Method::adams ? CV_ADAMS : CV_BDF, context_.get())) {
    void* const cvode = memory_.get();
    require(cvode != nullptr, "CVodeCreate");
    require(CVodeSetErrHandlerFn(cvode, keep_message, &callbacks_) == CV_SUCCESS, "CVodeSetErrHandlerFn");
    require(CVodeInit(cvode, derivative_callback, t, state_.get()) == CV_SUCCESS, "CVodeInit");
    require(CVodeSVtolerances(cvode, control.relative, absolute_.get()) == CV_SUCCESS, "CVodeSVtolerances");
    CVodeSetUserData(cvode, &callbacks_);
    // In place of 3: at the passage from slip to stick Newton's iteration meets a kink, and a few iterations more cost
    // less than the Jacobian, a derivative a column, that a failure asks for (docs/slow_phase.md).
    CVodeSetMaxNonlinIters(cvode, 7);
    CVodeSetMaxErrTestFails(cvode, kMostFailuresInAStep);
    CVodeSetMaxConvFails(cvode, kMostFailuresInAStep);
    if (std::isfinite(control.greatest_step)) CVodeSetMaxStep(cvode, control.greatest_step);
    if (method == Method::adams) {
      iterate_to_a_fixed_point();
    } else {
      iterate_by_newton();
    }
  }

  Outcome step(double t_end, double least_step, double& t, Eigen::VectorXd& y) override {
    void* const cvode = memory_.get();
    CVodeSetStopTime(cvode, t_end);
    CVodeSetMinStep(cvode, least_step);
    double reached = t;
    const int status = CVode(cvode, t_end, state_.get(), &reached, CV_ONE_STEP);
    if (status < 0) return outcome_of(status);
    t = reached;
    y = values(state_.get());
    return Outcome::accepted;
  }

  bool interpolate(double t, Eigen::VectorXd& y) override {
    const Vector at = make_vector(y, context_);
    const bool success = CVodeGetDky(memory_.get(), t, 0, at.get()) == CV_SUCCESS;
    if (success) y = values(at.get());
    return success;
  }

  Counts counts() const override {
    long error_tests = 0, solves = 0, iterations = 0;
    CVodeGetNumErrTestFails(memory_.get(), &error_tests);
    CVodeGetNumStepSolveFails(memory_.get(), &solves);
    CVodeGetNumNonlinSolvIters(memory_.get(), &iterations);
    return {error_tests, solves, iterations};
  }

  int order() const override {
    int order = 0;
    CVodeGetLastOrder(memory_.get(), &order);
    return order;
  }

  std::string message() const override { return callbacks_.message; }

 private:
  void iterate_to_a_fixed_point() {
    fixed_point_.reset(SUNNonlinSol_FixedPoint(state_.get(), 0, context_.get()));
    require(CVodeSetNonlinearSolver(memory_.get(), fixed_point_.get()) == CV_SUCCESS, "CVodeSetNonlinearSolver");
  }

  void iterate_by_newton() {
    dense_ = std::make_unique<DenseSystem>(state_, values(state_.get()).size(), context_);
    require(CVodeSetLinearSolver(memory_.get(), dense_->solver.get(), dense_->matrix.get()) == CV_SUCCESS,
            "CVodeSetLinearSolver");
    require(CVodeSetJacFn(memory_.get(), jacobian_callback) == CV_SUCCESS, "CVodeSetJacFn");
  }

  Outcome outcome_of(int status) const {
    switch (status) {
      case CV_ERR_FAILURE:
        return Outcome::error_test;
      case CV_CONV_FAILURE:
        return callbacks_.equation.refused_last() ? Outcome::refused : Outcome::nonlinear;
      case CV_FIRST_RHSFUNC_ERR:
      case CV_REPTD_RHSFUNC_ERR:
      case CV_UNREC_RHSFUNC_ERR:
        return Outcome::refused;
      case CV_TOO_MUCH_ACC:
        return Outcome::tolerances_too_fine;
      default:
        return Outcome::other;
    }
  }

  Context context_ = make_context();
  Callbacks callbacks_;
  Vector state_, absolute_;
  NonlinearSolver fixed_point_;
  std::unique_ptr<DenseSystem> dense_;
  std::unique_ptr<void, FreedBy<free_cvode>> memory_;
};

}  // namespace

std::unique_ptr<Solver> make_cvode(Method method, CountedEquation& equation, const StepControl& control, double t,
                                   const Eigen::VectorXd& y) {
  return std::make_unique<Cvode>(method, equation, control, t, y);
}

}  // namespace pcm::simulate
