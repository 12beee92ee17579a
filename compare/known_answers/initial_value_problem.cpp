// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/initial_value_problem.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace pcm::compare {

namespace {

using Map = Eigen::Map<Eigen::VectorXd>;

struct FreeContext {
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
};
struct FreeVector {
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
};
struct FreeSolver {
  void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
};
struct FreeIntegrator {
  void operator()(void* integrator) const { CVodeFree(&integrator); }
};
using Context = std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeContext>;
using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeVector>;
using Solver = std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, FreeSolver>;
using Integrator = std::unique_ptr<void, FreeIntegrator>;

/// What CVODE's callbacks see. They are C functions: an exception waits here until CVODE has returned.
struct Callbacks {
  const InitialValueProblem& problem;
  std::exception_ptr thrown;
};

Eigen::VectorXd values(N_Vector y) {
  return Map(N_VGetArrayPointer(y), N_VGetLength(y));
}

int derivative_of(double t, N_Vector y, N_Vector dy, void* user_data) {
  Callbacks& callbacks = *static_cast<Callbacks*>(user_data);
  try {
    Map(N_VGetArrayPointer(dy), N_VGetLength(dy)) = callbacks.problem.derivative(t, values(y));
    return 0;
  } catch (...) {
    callbacks.thrown = std::current_exception();
    return -1;
  }
}

int events_of(double t, N_Vector y, double* event, void* user_data) {
  Callbacks& callbacks = *static_cast<Callbacks*>(user_data);
  try {
    const Eigen::VectorXd at = values(y);
    for (const auto& function : callbacks.problem.events) *event++ = function(t, at);
    return 0;
  } catch (...) {
    callbacks.thrown = std::current_exception();
    return -1;
  }
}

/// CVODE reports by its return value as well; nothing is printed.
void say_nothing(int, const char*, const char*, char*, void*) {}

void require(bool success, const char* what) {
  if (!success) throw std::runtime_error(std::string("CVODE: ") + what + " failed");
}

Context make_context() {
  SUNContext context = nullptr;
  require(SUNContext_Create(nullptr, &context) == 0, "SUNContext_Create");
  return Context(context);
}

Vector make_vector(const Eigen::VectorXd& from, SUNContext context) {
  Vector vector(N_VNew_Serial(from.size(), context));
  require(vector != nullptr, "N_VNew_Serial");
  Map(N_VGetArrayPointer(vector.get()), from.size()) = from;
  return vector;
}

}  // namespace

std::optional<std::size_t> integrate(const InitialValueProblem& problem, const StepTolerance& tolerance, double t_end,
                                     double& t, Eigen::VectorXd& y, IntegrationWork& work) {
  Callbacks callbacks{problem, nullptr};
  const Context context = make_context();
  const Vector state = make_vector(y, context.get());
  const Vector absolute = make_vector(tolerance.absolute, context.get());
  const Solver solver(SUNNonlinSol_FixedPoint(state.get(), 0, context.get()));
  const Integrator integrator(CVodeCreate(CV_ADAMS, context.get()));
  void* const cvode = integrator.get();
  require(cvode != nullptr, "CVodeCreate");
  require(CVodeInit(cvode, derivative_of, t, state.get()) == CV_SUCCESS, "CVodeInit");
  CVodeSetErrHandlerFn(cvode, say_nothing, nullptr);
  CVodeSetUserData(cvode, &callbacks);
  require(CVodeSVtolerances(cvode, tolerance.relative, absolute.get()) == CV_SUCCESS, "CVodeSVtolerances");
  require(CVodeSetNonlinearSolver(cvode, solver.get()) == CV_SUCCESS, "CVodeSetNonlinearSolver");
  const auto events = static_cast<int>(problem.events.size());
  if (events > 0) {
    require(CVodeRootInit(cvode, events, events_of) == CV_SUCCESS, "CVodeRootInit");
    std::vector<int> rising(problem.events.size(), 1);
    CVodeSetRootDirection(cvode, rising.data());
    CVodeSetNoInactiveRootWarn(cvode);
  }
  // The polyhedral force law has a kink wherever a vertex or a barycentre enters; each costs a few rejected steps.
  constexpr long kMostSteps = 10'000'000;
  constexpr int kMostRejections = 100;
  CVodeSetMaxNumSteps(cvode, kMostSteps);
  CVodeSetMaxErrTestFails(cvode, kMostRejections);
  CVodeSetStopTime(cvode, t_end);

  const int outcome = CVode(cvode, t_end, state.get(), &t, CV_NORMAL);
  if (callbacks.thrown) std::rethrow_exception(callbacks.thrown);
  if (outcome < 0) {
    throw std::runtime_error("CVODE gave up at t = " + std::to_string(t) + ", status " + std::to_string(outcome));
  }
  y = values(state.get());
  long steps = 0, derivatives = 0;
  CVodeGetNumSteps(cvode, &steps);
  CVodeGetNumRhsEvals(cvode, &derivatives);
  work.steps += steps;
  work.derivatives += derivatives;
  if (outcome != CV_ROOT_RETURN) return std::nullopt;
  std::vector<int> found(problem.events.size(), 0);
  CVodeGetRootInfo(cvode, found.data());
  return static_cast<std::size_t>(std::find_if(found.begin(), found.end(), [](int f) { return f != 0; }) -
                                  found.begin());
}

}  // namespace pcm::compare
