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

/// df/dy, kept from one system matrix to the next. IDA asks for a new matrix where c_j has changed by more than a
/// factor of 5/3, as step and order do; df/dy need not be another one then, as in CVODE, which takes a new one after 50
/// steps or where Newton's iteration fails with the old one. So does this.
struct KeptJacobian {
  Eigen::MatrixXd dfdy;
  long step = -1;        ///< at which it was taken, -1: none yet
  double c_j = 0;        ///< of the last system matrix
  double asked_at = -1;  ///< time of the last system matrix

  bool still_good(double t, double new_c_j, long now) const {
    constexpr double kRatio = 0.6;  // of c_j, at which IDA asks: (1 - 1/4) / (1 + 1/4)
    constexpr long kOldest = 50;    // steps, as in CVODE
    const double ratio = new_c_j / c_j;
    // Asked again for the same step, or with much the same c_j: the iteration has failed.
    const bool failed = t == asked_at || (ratio > kRatio && ratio < 1 / kRatio);
    return step >= 0 && now - step <= kOldest && !failed;
  }
};

struct IdaCallbacks : Callbacks {
  void* memory = nullptr;
  KeptJacobian kept = {};
};

/// d residual / dy + c_j d residual / dy' = c_j - df/dy. IDA asks for it just after a residual at the same (t, y).
int residual_jacobian_callback(double t, double c_j, N_Vector y, N_Vector, N_Vector, SUNMatrix J, void* user_data,
                               N_Vector, N_Vector, N_Vector) {
  // `user_data` is what all callbacks are given, which here is part of more.
  auto& callbacks = static_cast<IdaCallbacks&>(callbacks_of(user_data));
  CountedEquation& equation = callbacks.equation;
  KeptJacobian& kept = callbacks.kept;
  long steps = 0;
  IDAGetNumSteps(callbacks.memory, &steps);
  if (!kept.still_good(t, c_j, steps)) {
    kept.step = -1;
    kept.dfdy.resize(equation.size(), equation.size());
    const Answer answer = equation.jacobian(t, N_VGetArrayPointer(y), nullptr, kept.dfdy.data());
    if (answer != Answer::given) return static_cast<int>(answer);
    kept.step = steps;
  }
  kept.c_j = c_j;
  kept.asked_at = t;
  Eigen::Map<Eigen::MatrixXd> system(SUNDenseMatrix_Data(J), equation.size(), equation.size());
  system = -kept.dfdy;
  system.diagonal().array() += c_j;
  return 0;
}

class Ida final : public Solver {
 public:
  Ida(CountedEquation& equation, const StepControl& control, double t, const Eigen::VectorXd& y)
      : callbacks_{{equation, {}}},
        state_(make_vector(y, context_)),
        slope_(make_vector(Eigen::VectorXd::Zero(y.size()), context_)),
        absolute_(make_vector(control.absolute, context_)),
        dense_(state_, y.size(), context_),
        memory_(IDACreate(context_.get())) {
    void* const ida = memory_.get();
    require(ida != nullptr, "IDACreate");
    callbacks_.memory = ida;
    require(IDASetErrHandlerFn(ida, keep_message, user_data()) == IDA_SUCCESS, "IDASetErrHandlerFn");
    require(IDAInit(ida, residual_callback, t, state_.get(), slope_.get()) == IDA_SUCCESS, "IDAInit");
    require(IDASVtolerances(ida, control.relative, absolute_.get()) == IDA_SUCCESS, "IDASVtolerances");
    require(IDASetLinearSolver(ida, dense_.solver.get(), dense_.matrix.get()) == IDA_SUCCESS, "IDASetLinearSolver");
    require(IDASetJacFn(ida, residual_jacobian_callback) == IDA_SUCCESS, "IDASetJacFn");
    IDASetUserData(ida, user_data());
    IDASetMaxErrTestFails(ida, kMostFailuresInAStep);
    IDASetMaxConvFails(ida, kMostFailuresInAStep);
    if (std::isfinite(control.greatest_step)) IDASetMaxStep(ida, control.greatest_step);
  }

  Outcome step(double t_end, double least_step, double& t, Eigen::VectorXd& y) override {
    void* const ida = memory_.get();
    if (!has_initial_slope_) {
      // IDA wants a slope that agrees with the state; the equation is asked in the step, not at the start.
      if (derivative_callback(t, state_.get(), slope_.get(), user_data()) != 0) return Outcome::refused;
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
  /// What callbacks_of takes back.
  Callbacks* user_data() { return &callbacks_; }

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
  IdaCallbacks callbacks_;
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
