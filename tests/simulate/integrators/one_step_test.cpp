// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/integrators/one_step.h"

#include <string>

#include "tests/simulate/integrators/equations.h"

namespace pcm::simulate {
namespace {

/// Euler's formula, too short by a tenth, whose errors and looks a test rules; `events` tells what it was asked, in
/// order.
struct ToldFormula final : OneStepFormula {
  struct Told {
    std::string events;
    int failures = 0;  ///< of the steps to come
    Answer look = Answer::given;
  };
  ToldFormula(CountedEquation& counted, Told& from) : equation(counted), told(from) {}

  int order() const override { return 1; }
  int error_power() const override { return 2; }
  Answer look(const SolutionPoint&) override {
    told.events += 'l';
    return told.look;
  }
  int steps_between_looks() const override { return 3; }
  double greatest_size() const override { return 0.01; }
  Answer step(const SolutionPoint& begin, double size, SolutionPoint& end, Eigen::VectorXd& error) override {
    told.events += told.failures > 0 ? 'f' : 's';
    end.y = begin.y + 0.9 * size * begin.dydt;
    error.setConstant(told.failures-- > 0 ? 1e3 : 0);
    return equation.derivative(end.t, end.y.data(), end.dydt.data());
  }

  CountedEquation& equation;
  Told& told;
};

struct OneStep : testing::Test {
  StepControl control = tolerance(1e-3, 1);
  CountedEquation equation{decay(), control.absolute};
  ToldFormula::Told told;
  std::unique_ptr<Solver> solver =
      make_one_step_solver(std::make_unique<ToldFormula>(equation, told), equation, control, 0, vector({1}));
  double t = 0;
  Eigen::VectorXd y = vector({1});

  void take_steps(int number) {
    for (int i = 0; i < number; ++i) ASSERT_EQ(solver->step(10, 1e-9, t, y), Outcome::accepted);
  }
};

TEST_F(OneStep, LooksAtTheStartAndAfterSoManySteps) {
  take_steps(7);
  EXPECT_EQ(told.events, "lssslsssls");
}

TEST_F(OneStep, LooksOnceWhereStepsFail) {
  take_steps(2);
  told.failures = 2;
  take_steps(5);
  EXPECT_EQ(told.events, "lssflfssslss");
}

TEST_F(OneStep, GoesOnWithWhatItHasSeenWhereItCanNotLook) {
  take_steps(3);
  told.look = Answer::try_smaller;
  take_steps(2);
  EXPECT_EQ(told.events, "lssslss");
}

TEST_F(OneStep, BeginsNotWithoutALook) {
  told.look = Answer::try_smaller;
  EXPECT_EQ(solver->step(10, 1e-9, t, y), Outcome::refused);
}

TEST_F(OneStep, TakesNoStepGreaterThanTheFormulaCan) {
  double before = 0;
  for (int i = 0; i < 20; ++i) {
    take_steps(1);
    EXPECT_LE(t - before, 0.01 + 1e-15);
    before = t;
  }
  EXPECT_GT(t, 0.1);
}

TEST_F(OneStep, EndsWhereItIsToldToAndLeavesNoSliver) {
  for (int i = 0; i < 100; ++i) {
    const double t_end = t + 0.01005;  // a little more than a step
    while (t < t_end) {
      ASSERT_EQ(solver->step(t_end, 1e-9, t, y), Outcome::accepted);
      ASSERT_TRUE(t == t_end || t < t_end - 1e-4) << t_end - t;
    }
  }
}

TEST_F(OneStep, StatesWithinItAreOnTheCubicThroughItsEnds) {
  take_steps(3);
  const double begin = t, y_begin = y[0];
  take_steps(1);
  const double h = t - begin, change = y[0] - y_begin;
  // Of decay: slopes -y.
  const double bend = 3 * change + h * (2 * y_begin + y[0]), twist = -h * (y_begin + y[0]) - 2 * change;
  for (const double part : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    Eigen::VectorXd within(1);
    ASSERT_TRUE(solver->interpolate(begin + part * h, within));
    EXPECT_NEAR(within[0], y_begin + part * (-h * y_begin + part * (bend + part * twist)), 1e-15);
  }
}

}  // namespace
}  // namespace pcm::simulate
