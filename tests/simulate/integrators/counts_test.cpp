// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>

#include "tests/simulate/integrators/equations.h"

namespace pcm::simulate {
namespace {

class Counts : public EachMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, Counts, testing::ValuesIn(kMethods), test_name);

bool is_implicit(Method method) {
  return method != Method::adams && !is_explicit_runge_kutta(method);
}

/// An oscillator of 500 1/s driven through a kink: Jacobians and failures of the error test.
Eigen::VectorXd kinked(double t, const Eigen::VectorXd& y) {
  return vector({y[1], -500 * y[0] - 10 * y[1] + (t > 0.5 ? 1e3 : 0)});
}

TEST_P(Counts, OfDerivativesAreTheCallsMade) {
  std::int64_t calls = 0;
  const auto equation = everywhere(2, [&calls](double t, const Eigen::VectorXd& y) {
    ++calls;
    return kinked(t, y);
  });
  const auto integrator = make_integrator(GetParam(), equation, tolerance(1e-5, 2));
  Failures failures;
  std::int64_t steps = 0;
  Work once;
  for (int run_number = 0; run_number < 2; ++run_number) {  // a second start adds to the first
    integrator->start(0, vector({1, 0}));
    EXPECT_EQ(integrator->work().derivatives + integrator->work().derivatives_for_jacobians, calls);
    run(*integrator, 1, [&](const Step& step) {
      ++steps;
      failures.error_test += step.failures.error_test;
      failures.nonlinear += step.failures.nonlinear;
      const Work& work = integrator->work();
      ASSERT_EQ(work.derivatives + work.derivatives_for_jacobians, calls);
      (void)integrator->state_at(step.t - step.size / 3);
      ASSERT_EQ(work.derivatives + work.derivatives_for_jacobians, calls) << "dense output calls no derivative";
    });
    if (run_number == 0) once = integrator->work();
  }
  const Work& work = integrator->work();
  EXPECT_EQ(work.steps, 2 * once.steps);
  EXPECT_EQ(work.failures.error_test, 2 * once.failures.error_test);
  EXPECT_EQ(work.nonlinear_iterations, 2 * once.nonlinear_iterations);
  EXPECT_EQ(work.steps, steps);
  EXPECT_EQ(work.failures.error_test, failures.error_test);
  EXPECT_EQ(work.failures.nonlinear, failures.nonlinear);
  EXPECT_GT(failures.error_test, 0);
  EXPECT_EQ(work.derivatives_for_jacobians, 2 * work.jacobians);
  EXPECT_EQ(work.jacobians > 0, is_implicit(GetParam()));
  EXPECT_EQ(work.nonlinear_iterations > 0, !is_explicit_runge_kutta(GetParam()));
}

TEST_P(Counts, ACallersJacobianTakesThePlaceOfDifferenceQuotients) {
  std::int64_t jacobians = 0;
  const auto with_jacobian = [&](double sign) {
    DifferentialEquation equation = everywhere(2, kinked);
    equation.jacobian = [&jacobians, sign](double t, const Eigen::VectorXd& y, const Eigen::VectorXd& dydt,
                                           Eigen::MatrixXd& J) {
      EXPECT_EQ(dydt, kinked(t, y));
      ++jacobians;
      J << 0, 1, -500, -10;
      J *= sign;
      return Evaluation::available;
    };
    const auto integrator = make_integrator(GetParam(), equation, tolerance(1e-5, 2));
    integrator->start(0, vector({1, 0}));
    run(*integrator, 1);
    return integrator->work();
  };
  const Work with = with_jacobian(1);
  EXPECT_EQ(with.derivatives_for_jacobians, 0);
  EXPECT_EQ(with.jacobians, jacobians);
  EXPECT_EQ(jacobians > 0, is_implicit(GetParam()));
  // A wrong one costs iterations: it is used.
  if (is_implicit(GetParam())) {
    EXPECT_GT(with_jacobian(-50).derivatives, 2 * with.derivatives);
  }
}

TEST_P(Counts, AStepEndsAtItsEndAndTheNextGoesOn) {
  const auto integrator = make_integrator(GetParam(), oscillator(), tolerance(1e-6, 2));
  integrator->start(0, vector({0, 1}));
  for (const double t_end : {1e-3, 2e-3, 0.5, 0.75, 3.0}) {
    run(*integrator, t_end, [&](const Step& step) { ASSERT_LE(step.t, t_end); });
    EXPECT_EQ(integrator->t(), t_end);
    EXPECT_NEAR(integrator->y()[0], std::sin(t_end), allowed_sum(GetParam(), 1e-6));
  }
  EXPECT_EQ(integrator->step(std::nextafter(3., 4.)).t, std::nextafter(3., 4.));
}

TEST_P(Counts, NoStepIsGreaterThanAllowed) {
  StepControl control = tolerance(1e-2, 2);
  control.greatest_step = 0.01;
  const auto integrator = make_integrator(GetParam(), oscillator(), control);
  integrator->start(0, vector({0, 1}));
  run(*integrator, 1, [&](const Step& step) { EXPECT_LE(step.size, 0.01 + 1e-14); });
}

}  // namespace
}  // namespace pcm::simulate
