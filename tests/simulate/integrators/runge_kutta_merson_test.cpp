// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of Simbody's integrator, against what the equation saw of it.
#include <cmath>
#include <cstdint>

#include "tests/simulate/integrators/equations.h"

namespace pcm::simulate {
namespace {

TEST(RungeKuttaMerson, TakesFiveDerivativesATry) {
  const auto kinked = everywhere(2, [](double t, const Eigen::VectorXd& y) {
    return vector({y[1], -500 * y[0] + (t > 0.5 ? 1e3 : 0)});
  });
  const auto integrator = make_integrator(Method::runge_kutta_merson, kinked, tolerance(1e-5, 2));
  integrator->start(0, vector({1, 0}));
  run(*integrator, 1);
  const Work& work = integrator->work();
  EXPECT_GT(work.failures.error_test, 0);
  // But for short steps whose last stage and end are the same to the last bit.
  const std::int64_t of_tries = 1 + 5 * (work.steps + work.failures.error_test);
  EXPECT_LE(work.derivatives, of_tries);
  EXPECT_GT(work.derivatives, of_tries - work.steps / 10);
}

// The solution is a straight line, which no step errs on, up to where there is nothing.
TEST(RungeKuttaMerson, ARefusedTryIsCountedOnceAndIsNoErrorTestFailure) {
  std::int64_t refusals = 0;
  const DifferentialEquation equation{1,
                                      [&refusals](double, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
                                        dydt[0] = 2;
                                        refusals += y[0] > 1;
                                        return y[0] > 1 ? Evaluation::not_here : Evaluation::available;
                                      },
                                      {}};
  StepControl control = tolerance(1e-6, 1);
  control.least_step = 1e-9;
  const auto integrator = make_integrator(Method::runge_kutta_merson, equation, control);
  integrator->start(0, vector({0}));
  run(*integrator, 0.4);
  // Ends much nearer than the step that is due: tried again ten times smaller, it may well end there again.
  const auto run_on = [&] {
    while (true) run(*integrator, integrator->t() + 0.003);
  };
  EXPECT_THROW(run_on(), IntegrationFailure);
  EXPECT_GT(refusals, 5);
  EXPECT_EQ(integrator->work().failures.not_here, refusals);
  EXPECT_EQ(integrator->work().failures.error_test, 0);
  EXPECT_NEAR(integrator->t(), 0.5, 1e-8);  // within some least steps
}

TEST(RungeKuttaMerson, AnEquationThatThrowsIsNotAskedAgain) {
  bool has_thrown = false;
  int calls_after = 0;
  const auto equation = everywhere(1, [&](double t, const Eigen::VectorXd& y) -> Eigen::VectorXd {
    calls_after += has_thrown;
    has_thrown = t > 0.5;
    if (has_thrown) throw 1;
    return -y;
  });
  const auto integrator = make_integrator(Method::runge_kutta_merson, equation, tolerance(1e-6, 1));
  integrator->start(0, vector({1}));
  EXPECT_THROW(run(*integrator, 1), int);
  EXPECT_EQ(calls_after, 0);
}

// Simbody would make a step by up to a thousandth greater to meet an end.
TEST(RungeKuttaMerson, NoStepIsStretchedBeyondTheGreatest) {
  StepControl control = tolerance(1e-2, 2);
  control.greatest_step = 0.01;
  const auto integrator = make_integrator(Method::runge_kutta_merson, oscillator(), control);
  integrator->start(0, vector({0, 1}));
  run(*integrator, 1);
  EXPECT_LE(integrator->step(integrator->t() + 1.0005 * control.greatest_step).size, control.greatest_step);
}

std::int64_t steps_with(double relative, double absolute) {
  StepControl control = tolerance(absolute, 2);
  control.relative = relative;
  const auto integrator = make_integrator(Method::runge_kutta_merson, oscillator(), control);
  integrator->start(0, vector({0, 1}));
  run(*integrator, 10);
  return integrator->work().steps;
}

// No component exceeds 1, so that relative tolerances up to the absolute one don't count.
TEST(RungeKuttaMerson, FollowsTheGreaterOfBothTolerances) {
  EXPECT_EQ(steps_with(1e-9, 1e-4), steps_with(1e-4, 1e-4));
  EXPECT_LT(steps_with(1e-4, 1e-9), 2 * steps_with(1e-4, 1e-4));
}

}  // namespace
}  // namespace pcm::simulate
