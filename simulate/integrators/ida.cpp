// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <ida/ida.h>

#include <cmath>

#include "simulate/integrators/solver.h"
#include "simulate/integrators/sundials_objects.h"

namespace pcm::simulate {

namespace {

void free_ida(void* ida) {
  IDAFree(&ida);
}

/// y' - f(t, y).
int residual_callback(double t, N_Vector y, N_Vector slope, N_Vector residual, void* user_data) {
  const int answer = derivative_callback(t, y, residual, user_data);
  if (answer == 0) values(residual) = values(slope) - values(residual);
  return answer;
}

/// d residual / dy + c_j d residual / dy' = c_j - df/dy. IDA asks for it just after a residual at the same (t, y).
int residual_jacobian_callback(double t, double c_j, N_Vector y, N_Vector, N_Vector, SUNMatrix J, void* user_data,
                               N_Vector, N_Vector, N_Vector) {
  CountedEquation& equation = callbacks_of(user_data).equation;
  const Answer answer = equation.jacobian(t, N_VGetArrayPointer(y), nullptr, SUNDenseMatrix_Data(J));
  if (answer != Answer::given) return static_cast<int>(answer);
  Eigen::Map<Eigen::MatrixXd> system(SUNDenseMatrix_Data(J), equation.size(), equation.size());
  system = -system;
  system.diagonal().array() += c_j;
  return 0;
}

class Ida final : public Solver {
 public:
  Ida(CountedEquation& equation, const StepControl& control, double t, const Eigen::VectorXd& y)
      : callbacks_{equation, {}},
        state_(make_vector(y, context_)),
        slope_(make_vector(Eigen::VectorXd::Zero(y.size()), context_)),
        absolute_(make_vector(control.absolute, context_)),
        dense_(state_, y.size(), context_),
        memory_(IDACreate(context_.get())) {
    void* const ida = memory_.get();
    require(ida != nullptr, "IDACreate");
    require(IDASetErrHandlerFn(ida, keep_message, &callbacks_) == IDA_SUCCESS, "IDASetErrHandlerFn");
    require(IDAInit(ida, residual_callback, t, state_.get(), slope_.get()) == IDA_SUCCESS, "IDAInit");
    require(IDASVtolerances(ida, control.relative, absolute_.get()) == IDA_SUCCESS, "IDASVtolerances");
    require(IDASetLinearSolver(ida, dense_.solver.get(), dense_.matrix.get()) == IDA_SUCCESS, "IDASetLinearSolver");
    require(IDASetJacFn(ida, residual_jacobian_callback) == IDA_SUCCESS, "IDASetJacFn");
    IDASetUserData(ida, &callbacks_);
    IDASetMaxErrTestFails(ida, kMostFailuresInAStep);
    IDASetMaxConvFails(ida, kMostFailuresInAStep);
    if (std::isfinite(control.greatest_step)) IDASetMaxStep(ida, control.greatest_step);
  }

  Outcome step(double t_end, double least_step, double& t, Eigen::VectorXd& y) override {
    void* const ida = memory_.get();
    if (!has_initial_slope_) {
      // IDA wants a slope that agrees with the state; the equation is asked in the step, not at the start.
      if (derivative_callback(t, state_.get(), slope_.get(), &callbacks_) != 0) return Outcome::refused;
      require(IDAReInit(ida, t, state_.get(), slope_.get()) == IDA_SUCCESS, "IDAReInit");
      has_initial_slope_ = true;
    }
    IDASetStopTime(ida, t_end);
    IDASetMinStep(ida, least_step);
    double reached = t;
    const int status = IDASolve(ida, t_end, &reached, state_.get(), slope_.get(), IDA_ONE_STEP);
    if (status < 0) return outcome_of(status);
    t = reached;
    y = values(state_.get());
    return Outcome::accepted;
  }

  bool interpolate(double t, Eigen::VectorXd& y) override {
    const Vector at = make_vector(y, context_);
    const bool success = IDAGetDky(memory_.get(), t, 0, at.get()) == IDA_SUCCESS;
    if (success) y = values(at.get());
    return success;
  }

  Counts counts() const override {
    long error_tests = 0, solves = 0, iterations = 0;
    IDAGetNumErrTestFails(memory_.get(), &error_tests);
    IDAGetNumStepSolveFails(memory_.get(), &solves);
    IDAGetNumNonlinSolvIters(memory_.get(), &iterations);
    return {error_tests, solves, iterations};
  }

  int order() const override {
    int order = 0;
    IDAGetLastOrder(memory_.get(), &order);
    return order;
  }

  std::string message() const override { return callbacks_.message; }

 private:
  Outcome outcome_of(int status) const {
    switch (status) {
      case IDA_ERR_FAIL:
        return Outcome::error_test;
      case IDA_CONV_FAIL:
        return callbacks_.equation.refused_last() ? Outcome::refused : Outcome::nonlinear;
      case IDA_FIRST_RES_FAIL:
      case IDA_REP_RES_ERR:
        return Outcome::refused;
      case IDA_TOO_MUCH_ACC:
        return Outcome::tolerances_too_fine;
      default:
        return Outcome::other;
    }
  }

  Context context_ = make_context();
  Callbacks callbacks_;
  Vector state_, slope_, absolute_;
  DenseSystem dense_;
  std::unique_ptr<void, FreedBy<free_ida>> memory_;
  bool has_initial_slope_ = false;
};

}  // namespace

std::unique_ptr<Solver> make_ida(CountedEquation& equation, const StepControl& control, double t,
                                 const Eigen::VectorXd& y) {
  return std::make_unique<Ida>(equation, control, t, y);
}

}  // namespace pcm::simulate
