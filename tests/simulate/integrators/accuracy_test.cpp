// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/simulate/integrators/equations.h"

namespace pcm::simulate {
namespace {

class Accuracy : public EachMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, Accuracy, testing::ValuesIn(kMethods), test_name);
class StiffAccuracy : public EachMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, StiffAccuracy, testing::ValuesIn(kStiffMethods), test_name);

/// The greatest errors at the ends of steps and, by dense output, within them.
struct Errors {
  double of_steps = 0, within_steps = 0;
};

template <typename Solution>
Errors errors(Method method, const DifferentialEquation& equation, const Solution& solution, double t_end,
              const StepControl& control) {
  const auto integrator = make_integrator(method, equation, control);
  integrator->start(0, solution(0));
  Errors greatest;
  double begin = 0;
  const auto error_at = [&](double t) { return (integrator->state_at(t) - solution(t)).cwiseAbs().maxCoeff(); };
  run(*integrator, t_end, [&](const Step& step) {
    EXPECT_EQ(step.t, integrator->t());
    EXPECT_EQ(step.size, step.t - begin);
    greatest.of_steps = std::max(greatest.of_steps, error_at(step.t));
    for (const double part : {0.1, 0.25, 0.5, 0.75, 0.9}) {
      greatest.within_steps = std::max(greatest.within_steps, error_at(begin + part * (step.t - begin)));
    }
    begin = step.t;
  });
  EXPECT_EQ(integrator->t(), t_end);
  return greatest;
}

template <typename Solution>
void expect_errors_to_fall(Method method, const DifferentialEquation& equation, const Solution& solution,
                           double t_end) {
  double coarser = 1;
  for (const double both : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const Errors greatest = errors(method, equation, solution, t_end, tolerance(both, equation.size));
    std::printf("%s, tolerance %g: error of steps %.2g, within them %.2g\n", std::string(name(method)).c_str(), both,
                greatest.of_steps, greatest.within_steps);
    EXPECT_LT(greatest.of_steps, allowed_sum(method, both));
    EXPECT_LT(greatest.of_steps, 0.2 * coarser);
    coarser = greatest.of_steps;
  }
}

TEST_P(Accuracy, OfDecayFollowsTheTolerance) {
  expect_errors_to_fall(
      GetParam(), decay(), [](double t) { return vector({std::exp(-t)}); }, 3);
}

TEST_P(Accuracy, OfAnOscillatorFollowsTheTolerance) {
  expect_errors_to_fall(
      GetParam(), oscillator(),
      [](double t) {
        return vector({std::sin(t), std::cos(t)});
      },
      10);
}

/// Each end asked for changes a step; the matrix of Newton's iteration has to follow.
TEST_P(Accuracy, IsNotSpoiltByEndsAtOddPlaces) {
  const auto integrator = make_integrator(GetParam(), decay(), tolerance(1e-9, 1));
  integrator->start(0, vector({1}));
  double greatest = 0, t_end = 0;
  while (t_end < 3) {
    t_end += 0.05 + 0.04 * std::sin(1e3 * t_end);
    run(*integrator, t_end,
        [&](const Step& step) { greatest = std::max(greatest, std::abs(integrator->y()[0] - std::exp(-step.t))); });
  }
  EXPECT_LT(greatest, 0.04 * allowed_sum(GetParam(), 1e-9));
}

TEST_P(Accuracy, OfDenseOutputIsThatOfTheSteps) {
  for (const double both : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const Errors greatest = errors(
        GetParam(), oscillator(),
        [](double t) {
          return vector({std::sin(t), std::cos(t)});
        },
        10, tolerance(both, 2));
    EXPECT_LT(greatest.within_steps, 2 * greatest.of_steps + both) << both;
  }
}

/// Van der Pol with mu = 1000, scaled to a period of about 1.6: y'' = mu^2 ((1 - y^2) y' - y) in time t / mu, along
/// which df/dy reaches -3 mu^2.
TEST_P(StiffAccuracy, VanDerPolIsDoneInFewSteps) {
  constexpr double mu = 1000;
  const auto equation = everywhere(2, [](double, const Eigen::VectorXd& y) {
    return vector({y[1], mu * mu * ((1 - y[0] * y[0]) * y[1] - y[0])});
  });
  const auto end_state = [&](double both, std::int64_t most_steps) {
    StepControl control = tolerance(both, 2);
    control.most_steps = most_steps;
    const auto integrator = make_integrator(GetParam(), equation, control);
    integrator->start(0, vector({2, 0}));
    run(*integrator, 2);
    std::printf("%s, tolerance %g: %ld steps, %ld derivatives, %ld for %ld Jacobians, y = %.10g\n",
                std::string(name(GetParam())).c_str(), both, static_cast<long>(integrator->work().steps),
                static_cast<long>(integrator->work().derivatives),
                static_cast<long>(integrator->work().derivatives_for_jacobians),
                static_cast<long>(integrator->work().jacobians), integrator->y()[0]);
    return integrator->y()[0];
  };
  // Hairer and Wanner, Solving ODEs II, test problem VDPOL at t = 2: 1.706167732170469 for eps = 1e-6.
  EXPECT_NEAR(end_state(1e-4, 3000), 1.706167732170469, 2e-2);
  EXPECT_NEAR(end_state(1e-7, 6000), 1.706167732170469, 2e-5);
}

/// The order seen when the step is halved, all errors let pass, so that the greatest step is taken all the way.
double observed_order(Method method, double step) {
  const auto error = [&](double size) {
    StepControl control = tolerance(0.5, 2);
    control.absolute.setConstant(1e6);
    control.greatest_step = size;
    const auto solution = [](double t) { return vector({std::sin(t), std::cos(t)}); };
    return errors(method, oscillator(), solution, 10, control).of_steps;
  };
  return std::log2(error(step) / error(step / 2));
}

TEST(Order, OfTheRungeKuttaMethodsIsTheirs) {
  EXPECT_NEAR(observed_order(Method::dormand_prince, 0.2), 5, 0.3);
  EXPECT_NEAR(observed_order(Method::rkc, 0.2), 2, 0.1);
  EXPECT_NEAR(observed_order(Method::runge_kutta_merson, 0.2), 4, 0.3);
}

TEST(Order, StepsTellIt) {
  for (const Method method : kMethods) {
    const auto integrator = make_integrator(method, oscillator(), tolerance(1e-12, 2));
    integrator->start(0, vector({0, 1}));
    int greatest = 0;
    run(*integrator, 10, [&](const Step& step) { greatest = std::max(greatest, step.order); });
    EXPECT_GE(greatest, method == Method::adams ? 6 : method == Method::rkc ? 2 : 4);
    EXPECT_LE(greatest, method == Method::adams ? 12 : 5);
  }
}

}  // namespace
}  // namespace pcm::simulate
