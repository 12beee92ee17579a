// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numeric>

#include "simulate/integrators/chebyshev_stages.h"
#include "simulate/integrators/spectral_radius.h"
#include "simulate/integrators/step_size.h"
#include "tests/simulate/integrators/equations.h"

namespace pcm::simulate {
namespace {

/// An oscillator and, apart from it, what decays at a rate of lambda.
DifferentialEquation oscillator_beside_decay(double lambda) {
  return everywhere(3, [=](double, const Eigen::VectorXd& y) { return vector({y[1], -y[0], -lambda * y[2]}); });
}

StepControl steps_of(double size, Eigen::Index components) {
  StepControl control = tolerance(1, components);
  control.absolute.setConstant(1e6);
  control.greatest_step = size;
  return control;
}

// The oscillator's error is that of all the stages which the decay asks for.
TEST(Rkc, IsOfSecondOrderWithManyStagesToo) {
  const double lambda = 1e4;
  const auto error = [&](double size) {
    const auto integrator = make_integrator(Method::rkc, oscillator_beside_decay(lambda), steps_of(size, 3));
    integrator->start(0, vector({0, 1, 0}));
    run(*integrator, 6.4);
    EXPECT_GT(integrator->work().derivatives, 30 * integrator->work().steps);
    return (integrator->y() - vector({std::sin(6.4), std::cos(6.4), 0})).norm();
  };
  EXPECT_NEAR(std::log2(error(0.1) / error(0.05)), 2, 0.1);
}

// A step asks for one derivative a stage; the power method has its share, at every 25th step.
TEST(Rkc, TakesStagesByTheRootOfTheStiffness) {
  const double size = 0.1;
  for (const double lambda : {1e2, 1e3, 1e4, 1e5, 1e6}) {
    const auto equation = everywhere(
        1, [=](double t, const Eigen::VectorXd& y) { return vector({-lambda * (y[0] - std::cos(t)) - std::sin(t)}); });
    const auto integrator = make_integrator(Method::rkc, equation, steps_of(size, 1));
    integrator->start(0, vector({1}));
    run(*integrator, 10, [&](const Step&) { ASSERT_NEAR(integrator->y()[0], std::cos(integrator->t()), 0.01); });
    const Work& work = integrator->work();
    EXPECT_EQ(work.failures.error_test, 0);
    const double a_step = static_cast<double>(work.derivatives) / static_cast<double>(work.steps);
    EXPECT_GE(a_step, chebyshev_stages_for(lambda * size)) << lambda;
    EXPECT_LE(a_step, chebyshev_stages_for(1.2 * lambda * size) + 0.5) << lambda;
  }
}

// It finds out by failing: steps shrink until they no longer pass the time, and the radius is looked for again.
TEST(Rkc, NoticesThatTheEquationTurnsStiff) {
  const auto equation = everywhere(1, [](double t, const Eigen::VectorXd& y) {
    return vector({-(t < 5 ? 1 : 1e4) * (y[0] - std::cos(t)) - std::sin(t)});
  });
  const auto integrator = make_integrator(Method::rkc, equation, tolerance(1e-4, 1));
  integrator->start(0, vector({1}));
  run(*integrator, 10, [&](const Step&) { ASSERT_NEAR(integrator->y()[0], std::cos(integrator->t()), 1e-3); });
  EXPECT_LT(integrator->work().failures.error_test, 40);
}

// The solution stops at 1; what tries to go on beyond 1.001 is tried smaller.
TEST(Rkc, AStepIntoWhatIsNotThereIsTriedSmallerAndCounted) {
  const DifferentialEquation equation{1,
                                      [](double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
                                        dydt[0] = t < 1 ? 1 : 0;
                                        return y[0] > 1.001 ? Evaluation::not_here : Evaluation::available;
                                      },
                                      {}};
  const auto integrator = make_integrator(Method::rkc, equation, tolerance(1e-2, 1));
  integrator->start(0, vector({0}));
  std::int64_t not_here = 0;
  run(*integrator, 5, [&](const Step& step) { not_here += step.failures.not_here; });
  EXPECT_GT(not_here, 0);
  EXPECT_LT(not_here, 10);
  EXPECT_EQ(integrator->work().failures.not_here, not_here);
  EXPECT_NEAR(integrator->y()[0], 1, 1e-3);
}

/// f = A y, seen through what counts calls.
double radius_of(const Eigen::MatrixXd& A, const Eigen::VectorXd& y, int looks = 1) {
  CountedEquation equation(
      everywhere(y.size(), [A](double, const Eigen::VectorXd& at) -> Eigen::VectorXd { return A * at; }),
      Eigen::VectorXd::Constant(y.size(), 1e-6));
  SpectralRadius radius(Eigen::VectorXd::Constant(y.size(), 1e-6));
  for (int i = 0; i < looks; ++i) EXPECT_EQ(radius.estimate(equation, {0, y, A * y}), Answer::given);
  return radius.value();
}

TEST(SpectralRadius, IsThatOfTheMatrixWithAMargin) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(4, 4);
  A.diagonal() << -3, -70, -1e4, -5;
  A(0, 2) = 300;
  EXPECT_NEAR(radius_of(A, vector({1, 2, 0.1, 5})), 1.2e4, 1e2);
  // A mass on a stiff spring with a strong damper: -2000 and -51 are the eigenvalues, 1e5 an entry.
  EXPECT_NEAR(radius_of((Eigen::MatrixXd(2, 2) << 0, 1, -1e5, -2051).finished(), vector({1e-4, 0.1})), 1.2 * 2001, 30);
}

TEST(SpectralRadius, OfFreeFlightAndOfRestIsNone) {
  const Eigen::MatrixXd flight = (Eigen::MatrixXd(2, 2) << 0, 1, 0, 0).finished();
  EXPECT_EQ(radius_of(flight, vector({3, 1}), 3), 0);
  EXPECT_EQ(radius_of(Eigen::MatrixXd::Zero(2, 2), vector({3, 1}), 3), 0);
}

TEST(SpectralRadius, LooksToTheOtherSideOfABound) {
  const auto bounded = [](double bound) {
    return CountedEquation({1,
                            [=](double, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
                              dydt = -100 * y;
                              return y[0] < bound ? Evaluation::not_here : Evaluation::available;
                            },
                            {}},
                           vector({1e-3}));
  };
  SpectralRadius radius(vector({1e-3}));
  CountedEquation one_side = bounded(1), no_side = bounded(2);
  EXPECT_EQ(radius.estimate(one_side, {0, vector({1}), vector({-100})}), Answer::given);
  EXPECT_NEAR(radius.value(), 120, 1e-6);
  EXPECT_EQ(radius.estimate(no_side, {0, vector({1}), vector({-100})}), Answer::given);
  EXPECT_NEAR(radius.value(), 120, 1e-6);  // the last one
  EXPECT_EQ(one_side.tries_not_here() + no_side.tries_not_here(), 0);
}

TEST(StepSizeControl, AimsBelowTheToleranceAndFollowsTheTrend) {
  StepSizeControl sizes(3);
  EXPECT_NEAR(sizes.after_accepted(1, 0.125), 0.8 * 2, 1e-12);
  // A step 1.6 times as large had 8 times the error, in place of 1.6^3: the trend says less than the error alone.
  EXPECT_NEAR(sizes.after_accepted(1.6, 1), 0.8 * 1.6 / 2, 1e-12);
  EXPECT_EQ(sizes.after_accepted(1.28, 1e-30), 10);
  EXPECT_NEAR(sizes.after_rejected(8), 0.4, 1e-12);
  EXPECT_EQ(sizes.after_rejected(1e30), 0.1);
  EXPECT_EQ(sizes.after_refused(), 0.25);
  for (const double growth : {1, 1, 10}) EXPECT_EQ(sizes.after_accepted(1, 1e-9), growth);
}

TEST(ErrorInTolerances, IsARootMeanSquare) {
  // Tolerances 1e-3 * 2 + 1e-3 and 1e-2.
  EXPECT_NEAR(error_in_tolerances(vector({3e-3, -2e-2}), vector({-2, 0}), 1e-3, vector({1e-3, 1e-2})),
              std::sqrt((1 + 4) / 2.), 1e-12);
}

}  // namespace
}  // namespace pcm::simulate
