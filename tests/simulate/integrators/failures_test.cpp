// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "tests/simulate/integrators/equations.h"

namespace pcm::simulate {
namespace {

class Failing : public EachMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, Failing, testing::ValuesIn(kMethods), test_name);

/// f where y_0 <= bound, elsewhere `beyond`.
template <typename Function>
DifferentialEquation up_to(double bound, Eigen::Index size, Function f, Evaluation beyond) {
  return {size,
          [=](double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
            dydt = f(t, y);
            if (y[0] <= bound) return Evaluation::available;
            dydt.setConstant(std::numeric_limits<double>::quiet_NaN());
            return beyond;
          },
          {}};
}

std::string message_of(Integrator& integrator, double t_end) {
  try {
    run(integrator, t_end);
  } catch (const IntegrationFailure& failure) {
    EXPECT_EQ(failure.t(), integrator.t());
    return failure.what();
  }
  return "";
}

/// Creeps up to 0.9999 and never beyond; the states that steps try do.
Eigen::VectorXd landing(double, const Eigen::VectorXd& y) {
  return vector({y[1], -1e4 * (y[0] - 0.9999) - 200 * y[1]});
}

TEST_P(Failing, AStepIntoWhatIsNotThereIsTriedSmallerAndCounted) {
  if (GetParam() == Method::rkc) return;  // its stages don't lie beyond its steps: rkc_test.cpp
  // Few stages of the diagonally implicit method do; those of the others may end beyond a bound so near.
  const double bound = GetParam() == Method::esdirk ? 0.99991 : 1;
  for (const Evaluation beyond : {Evaluation::not_here, Evaluation::available}) {
    const auto integrator = make_integrator(GetParam(), up_to(bound, 2, landing, beyond), tolerance(1e-2, 2));
    integrator->start(0, vector({0, 1}));
    Failures failures;
    run(*integrator, 2, [&](const Step& step) {
      failures.not_here += step.failures.not_here;
      failures.not_finite += step.failures.not_finite;
      EXPECT_LE(integrator->y()[0], bound + 1e-2);
    });
    std::printf("%s: %ld not here, %ld not finite, %ld nonlinear, %ld error test in %ld steps\n",
                std::string(name(GetParam())).c_str(), static_cast<long>(integrator->work().failures.not_here),
                static_cast<long>(integrator->work().failures.not_finite),
                static_cast<long>(integrator->work().failures.nonlinear),
                static_cast<long>(integrator->work().failures.error_test), static_cast<long>(integrator->work().steps));
    EXPECT_EQ(failures.not_here > 0, beyond == Evaluation::not_here);
    EXPECT_EQ(failures.not_finite > 0, beyond == Evaluation::available);
    EXPECT_EQ(integrator->work().failures.not_here, failures.not_here);
    EXPECT_EQ(integrator->work().failures.not_finite, failures.not_finite);
    EXPECT_NEAR(integrator->y()[0], 0.9999, 1e-2);
    // Simbody makes a refused step ten times smaller and the next ones up to five times greater, whatever was refused.
    const int part = GetParam() == Method::runge_kutta_merson ? 2 : 4;
    EXPECT_LT(failures.not_here + failures.not_finite, integrator->work().steps / part);
    if (GetParam() != Method::adams) {  // whose iteration fails by itself where steps are great
      EXPECT_EQ(integrator->work().failures.nonlinear, 0);
    }
  }
}

TEST_P(Failing, WhatCanNeverBePassedEndsWithItsTime) {
  for (const Evaluation beyond : {Evaluation::not_here, Evaluation::available}) {
    for (const double least : {0.0, 1e-6}) {
      StepControl control = tolerance(1e-6, 2);
      control.least_step = least;
      const auto rise = [](double, const Eigen::VectorXd&) { return vector({2, 1}); };
      const auto integrator = make_integrator(GetParam(), up_to(1, 2, rise, beyond), control);
      integrator->start(0, vector({0, 0}));
      const std::string message = message_of(*integrator, 2);
      EXPECT_NE(message.find(std::string(name(GetParam())) + " gave up at t = "), std::string::npos) << message;
      EXPECT_NE(message.find(beyond == Evaluation::not_here ? "can't be had" : "not finite"), std::string::npos)
          << message;
      EXPECT_EQ(message.find('\n'), std::string::npos);
      EXPECT_NEAR(integrator->t(), 0.5, 1e-5);
      EXPECT_NEAR(integrator->y()[0], 1, 2e-5);
      EXPECT_GT(integrator->work().failures.not_here + integrator->work().failures.not_finite, 0);
      if (least == 0) std::printf("%s\n", message.c_str());
    }
  }
}

TEST_P(Failing, ADerivativeThatIsNotThereAtTheStartEndsThere) {
  const auto nowhere = up_to(-1, 2, landing, Evaluation::not_here);
  const auto integrator = make_integrator(GetParam(), nowhere, tolerance(1e-6, 2));
  integrator->start(0.25, vector({0, 0}));
  EXPECT_NE(message_of(*integrator, 2).find("gave up at t = 0.25 s: the derivative can't be had"), std::string::npos);
}

TEST_P(Failing, StepsAsSmallAsAllowedThatFailTheErrorTestAreGivenUp) {
  StepControl control = tolerance(1e-10, 1);
  control.least_step = 1e-2;
  const auto jump = everywhere(1, [](double t, const Eigen::VectorXd&) { return vector({t < 1 ? 0. : 1.}); });
  const auto integrator = make_integrator(GetParam(), jump, control);
  integrator->start(0, vector({0}));
  const std::string message = message_of(*integrator, 2);
  EXPECT_NE(message.find("error of a step stays too large"), std::string::npos) << message;
  EXPECT_NEAR(integrator->t(), 1, 0.1);
  EXPECT_GT(integrator->work().failures.error_test, 0);
}

TEST_P(Failing, TooManyStepsAreGivenUp) {
  StepControl control = tolerance(1e-6, 2);
  control.most_steps = 7;
  const auto integrator = make_integrator(GetParam(), oscillator(), control);
  for (int starts = 0; starts < 2; ++starts) {
    integrator->start(0, vector({0, 1}));
    EXPECT_NE(message_of(*integrator, 100).find("7 steps were taken"), std::string::npos);
  }
  EXPECT_EQ(integrator->work().steps, 14);
}

TEST_P(Failing, TolerancesFinerThanRoundingAreSaid) {
  const auto integrator = make_integrator(GetParam(), oscillator(), tolerance(1e-17, 2));
  integrator->start(0, vector({0, 1}));
  const std::string message = message_of(*integrator, 1);
  EXPECT_NE(message.find("finer than rounding"), std::string::npos) << message;
}

/// Of a stiffness that Newton's iteration isn't told.
TEST(FailingNewton, IsCountedAndGivenUp) {
  for (const Method method : kStiffMethods) {
    DifferentialEquation equation =
        everywhere(1, [](double t, const Eigen::VectorXd& y) { return vector({-1e8 * (y[0] - std::cos(t))}); });
    equation.jacobian = [](double, const Eigen::VectorXd&, const Eigen::VectorXd&, Eigen::MatrixXd& J) {
      J(0, 0) = 0;
      return Evaluation::available;
    };
    StepControl control = tolerance(1e-6, 1);
    control.least_step = 1e-6;
    const auto integrator = make_integrator(method, equation, control);
    integrator->start(0, vector({1}));
    const std::string message = message_of(*integrator, 1);
    EXPECT_NE(message.find("nonlinear iteration does not converge"), std::string::npos) << message;
    EXPECT_GT(integrator->work().failures.nonlinear, 0);
    EXPECT_EQ(integrator->work().failures.not_here, 0);
  }
}

struct OwnException {
  double t;
};

TEST_P(Failing, WhatTheEquationThrowsComesOut) {
  for (const bool in_jacobian : {false, true}) {
    DifferentialEquation equation = everywhere(1, [=](double t, const Eigen::VectorXd& y) -> Eigen::VectorXd {
      if (!in_jacobian && t > 0.5) throw OwnException{t};
      return -y;
    });
    if (in_jacobian) {
      equation.jacobian = [](double t, const Eigen::VectorXd&, const Eigen::VectorXd&, Eigen::MatrixXd&) -> Evaluation {
        throw OwnException{t};
      };
    }
    const auto integrator = make_integrator(GetParam(), equation, tolerance(1e-6, 1));
    integrator->start(0, vector({1}));
    const bool has_jacobians = GetParam() != Method::adams && !is_explicit_runge_kutta(GetParam());
    if (in_jacobian && !has_jacobians) continue;
    EXPECT_THROW(run(*integrator, 1), OwnException);
    const double t = integrator->t();
    EXPECT_LE(t, 0.5);
    EXPECT_NEAR(integrator->y()[0], std::exp(-t), 1e-4);
    integrator->start(0, vector({1}));  // usable again
    if (!in_jacobian) {
      EXPECT_NO_THROW(run(*integrator, 0.4));
    }
  }
}

TEST_P(Failing, NothingIsPrinted) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const auto rise = [](double, const Eigen::VectorXd&) { return vector({2}); };
  const auto integrator = make_integrator(GetParam(), up_to(1, 1, rise, Evaluation::not_here), tolerance(1e-6, 1));
  integrator->start(0, vector({0}));
  (void)message_of(*integrator, 2);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace pcm::simulate
