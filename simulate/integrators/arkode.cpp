// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

#include <algorithm>
#include <cmath>

#include "simulate/integrators/dormand_prince_interpolant.h"
#include "simulate/integrators/solver.h"
#include "simulate/integrators/sundials_objects.h"

namespace pcm::simulate {

namespace {

/// ERKStep and ARKStep have the same functions under two names.
struct Stepper {
  decltype(&ERKStepEvolve) evolve;
  decltype(&ERKStepReset) reset;
  decltype(&ERKStepGetDky) interpolate;
  decltype(&ERKStepGetNumSteps) steps;
  decltype(&ERKStepSVtolerances) set_tolerances;
  decltype(&ERKStepSetErrHandlerFn) set_error_handler;
  decltype(&ERKStepSetUserData) set_user_data;
  decltype(&ERKStepSetInterpolantDegree) set_interpolant_degree;
  decltype(&ERKStepSetMaxErrTestFails) set_most_error_test_failures;
  decltype(&ERKStepSetMaxStep) set_greatest_step;
  decltype(&ERKStepSetMinStep) set_least_step;
  decltype(&ERKStepSetInitStep) set_first_step;
  decltype(&ERKStepSetStopTime) set_stop_time;
  decltype(&ERKStepGetCurrentStep) tried_step;
  decltype(&ERKStepGetNumErrTestFails) error_test_failures;
  decltype(&ERKStepFree) free;
};
constexpr Stepper kExplicit{ERKStepEvolve,
                            ERKStepReset,
                            ERKStepGetDky,
                            ERKStepGetNumSteps,
                            ERKStepSVtolerances,
                            ERKStepSetErrHandlerFn,
                            ERKStepSetUserData,
                            ERKStepSetInterpolantDegree,
                            ERKStepSetMaxErrTestFails,
                            ERKStepSetMaxStep,
                            ERKStepSetMinStep,
                            ERKStepSetInitStep,
                            ERKStepSetStopTime,
                            ERKStepGetCurrentStep,
                            ERKStepGetNumErrTestFails,
                            ERKStepFree};
constexpr Stepper kImplicit{ARKStepEvolve,
                            ARKStepReset,
                            ARKStepGetDky,
                            ARKStepGetNumSteps,
                            ARKStepSVtolerances,
                            ARKStepSetErrHandlerFn,
                            ARKStepSetUserData,
                            ARKStepSetInterpolantDegree,
                            ARKStepSetMaxErrTestFails,
                            ARKStepSetMaxStep,
                            ARKStepSetMinStep,
                            ARKStepSetInitStep,
                            ARKStepSetStopTime,
                            ARKStepGetCurrentStep,
                            ARKStepGetNumErrTestFails,
                            ARKStepFree};

/// Callbacks of the explicit method, whose slopes make its dense output.
struct ExplicitCallbacks : Callbacks {
  DormandPrinceInterpolant interpolant;
};

int explicit_derivative_callback(double t, N_Vector y, N_Vector dydt, void* user_data) {
  const int answer = derivative_callback(t, y, dydt, user_data);
  auto& callbacks = static_cast<ExplicitCallbacks&>(callbacks_of(user_data));
  if (answer == 0) callbacks.interpolant.add_slope(values(dydt));
  return answer;
}

/// By how much a step may exceed the one before: ARKODE's default for this method, and its least value.
constexpr double kGrowth = 25, kNoGrowth = 1 + 1e-12;

struct FreeStepper {
  decltype(&ERKStepFree) free = nullptr;
  void operator()(void* memory) const { free(&memory); }
};

class Arkode final : public Solver {
 public:
  Arkode(Method method, CountedEquation& equation, const StepControl& control, double t, const Eigen::VectorXd& y)
      : stepper_(method == Method::esdirk ? kImplicit : kExplicit),
        order_(method == Method::esdirk ? 4 : 5),
        callbacks_{{equation, {}}, {}},
        state_(make_vector(y, context_)),
        last_state_(make_vector(y, context_)),
        absolute_(make_vector(control.absolute, context_)),
        memory_(method == Method::esdirk ? ARKStepCreate(nullptr, derivative_callback, t, state_.get(), context_.get())
                                         : ERKStepCreate(explicit_derivative_callback, t, state_.get(), context_.get()),
                FreeStepper{stepper_.free}) {
    void* const arkode = memory_.get();
    require(arkode != nullptr, "ERKStepCreate, ARKStepCreate");
    require(stepper_.set_error_handler(arkode, keep_message, static_cast<Callbacks*>(&callbacks_)) == ARK_SUCCESS,
            "SetErrHandlerFn");
    require(stepper_.set_tolerances(arkode, control.relative, absolute_.get()) == ARK_SUCCESS, "SVtolerances");
    stepper_.set_user_data(arkode, static_cast<Callbacks*>(&callbacks_));
    stepper_.set_most_error_test_failures(arkode, kMostFailuresInAStep);
    if (std::isfinite(control.greatest_step)) stepper_.set_greatest_step(arkode, control.greatest_step);
    // Hermite's cubic; higher degrees would ask the equation for each output.
    require(stepper_.set_interpolant_degree(arkode, 3) == ARK_SUCCESS, "SetInterpolantDegree");
    if (method == Method::esdirk) {
      make_implicit(y.size());
    } else {
      require(ERKStepSetTableNum(arkode, ARKODE_DORMAND_PRINCE_7_4_5) == ARK_SUCCESS, "ERKStepSetTableNum");
    }
  }

  Outcome step(double t_end, double least_step, double& t, Eigen::VectorXd& y) override {
    void* const arkode = memory_.get();
    stepper_.set_least_step(arkode, least_step);
    const long steps_before = steps();
    double reached = t;
    for (int tries = 0;; ++tries) {
      stepper_.set_stop_time(arkode, t_end);
      const int status = stepper_.evolve(arkode, t_end, state_.get(), &reached, ARK_ONE_STEP);
      if (status >= 0) break;
      const bool ends = tries == kMostFailuresInAStep || !callbacks_.equation.refused_last() || is_final(status);
      if (ends || !try_smaller(t, t_end, least_step)) return outcome_of(status);
    }
    // A t_end within rounding of t is reached without a step.
    if (!dense_ && steps() > steps_before) accept_explicit(t, reached);
    t = reached;
    y = values(state_.get());
    values(last_state_.get()) = y;
    return Outcome::accepted;
  }

  bool interpolate(double t, Eigen::VectorXd& y) override {
    if (!dense_) {
      y = callbacks_.interpolant.state_at((t - begin_) / (end_ - begin_));
      return true;
    }
    const Vector at = make_vector(y, context_);
    const bool success = stepper_.interpolate(memory_.get(), t, 0, at.get()) == ARK_SUCCESS;
    if (success) y = values(at.get());
    return success;
  }

  Counts counts() const override {
    long error_tests = 0, solves = 0, iterations = 0;
    stepper_.error_test_failures(memory_.get(), &error_tests);
    if (dense_) {
      ARKStepGetNumStepSolveFails(memory_.get(), &solves);
      ARKStepGetNumNonlinSolvIters(memory_.get(), &iterations);
    }
    return {error_tests, solves + restarts_, iterations};
  }

  int order() const override { return order_; }

  std::string message() const override { return callbacks_.message; }

 private:
  long steps() const {
    long steps = 0;
    stepper_.steps(memory_.get(), &steps);
    return steps;
  }

  void make_implicit(Eigen::Index size) {
    void* const arkode = memory_.get();
    require(ARKStepSetTableNum(arkode, ARKODE_ESDIRK436L2SA_6_3_4, ARKODE_ERK_NONE) == ARK_SUCCESS,
            "ARKStepSetTableNum");
    dense_ = std::make_unique<DenseSystem>(state_, size, context_);
    require(ARKStepSetLinearSolver(arkode, dense_->solver.get(), dense_->matrix.get()) == ARK_SUCCESS,
            "ARKStepSetLinearSolver");
    require(ARKStepSetJacFn(arkode, jacobian_callback) == ARK_SUCCESS, "ARKStepSetJacFn");
    // The slope of a stage follows from the stage solved; evaluated again it would carry the iteration's error times
    // the stiffness, and could be refused where ARKODE knows no smaller step.
    ARKStepSetDeduceImplicitRhs(arkode, 1);
    ARKStepSetMaxConvFails(arkode, kMostFailuresInAStep);
    // The matrix follows every change of the step. ARKODE would keep it up to 20 %, and with it the rate of convergence
    // seen before: in linear stretches that is so good that a step changed by 5 % to meet t_end was accepted after one
    // iteration with 1e5 times the error allowed. Factorising is cheap beside a derivative.
    ARKStepSetDeltaGammaMax(arkode, 1e-12);
    // Nor is a rate of convergence taken over from stage to stage: behind a kink (a bumper met, a contact closed) the
    // old rate says that one iteration with the old Jacobian is enough, when it is not. With 1 in place of 0.3 an
    // iteration is good where its own change is small enough.
    ARKStepSetNonlinCRDown(arkode, 1);
    ARKStepSetMaxNonlinIters(arkode, 10);  // in place of 3, which that often needs more than
  }

  void accept_explicit(double begin, double end) {
    callbacks_.interpolant.accept(end - begin, values(last_state_.get()), values(state_.get()));
    begin_ = begin;
    end_ = end;
    ERKStepSetMaxGrowth(memory_.get(), kGrowth);
  }

  /// Refusals that ARKODE has itself tried smaller.
  static bool is_final(int status) { return status == ARK_CONV_FAILURE || status == ARK_ERR_FAILURE; }

  /// ARKODE tries again smaller only where a nonlinear solver was refused; a refused explicit stage ends it. So it is
  /// set back to the last accepted state, a quarter of the step before it, as CVODE does. False below the least step.
  bool try_smaller(double t, double t_end, double least_step) {
    constexpr double kSmaller = 0.25;
    double tried = 0;
    stepper_.tried_step(memory_.get(), &tried);
    if (tried == 0) tried = 1e-3 * (t_end - t);  // refused while a first step was sought
    const double smaller = kSmaller * std::min(tried, t_end - t);
    if (smaller <= least_step) return false;
    ++restarts_;
    // The explicit method's next two steps don't grow, or every other try would be refused again.
    if (!dense_) ERKStepSetMaxGrowth(memory_.get(), kNoGrowth);
    callbacks_.equation.next_try();
    return stepper_.set_first_step(memory_.get(), smaller) == ARK_SUCCESS &&
           stepper_.reset(memory_.get(), t, last_state_.get()) == ARK_SUCCESS;
  }

  Outcome outcome_of(int status) const {
    if (status == ARK_ERR_FAILURE) return Outcome::error_test;
    if (status == ARK_TOO_MUCH_ACC) return Outcome::tolerances_too_fine;
    if (callbacks_.equation.refused_last()) return Outcome::refused;
    return status == ARK_CONV_FAILURE ? Outcome::nonlinear : Outcome::other;
  }

  Context context_ = make_context();
  const Stepper& stepper_;
  int order_;
  ExplicitCallbacks callbacks_;
  Vector state_, last_state_, absolute_;
  std::unique_ptr<DenseSystem> dense_;
  std::unique_ptr<void, FreeStepper> memory_;
  double begin_ = 0, end_ = 0;  ///< of the last step, explicit method
  std::int64_t restarts_ = 0;   ///< refused tries that ARKODE doesn't count
};

}  // namespace

std::unique_ptr<Solver> make_arkode(Method method, CountedEquation& equation, const StepControl& control, double t,
                                    const Eigen::VectorXd& y) {
  return std::make_unique<Arkode>(method, equation, control, t, y);
}

}  // namespace pcm::simulate
