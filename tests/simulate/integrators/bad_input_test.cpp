// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcm/bad_input.h"

#include <limits>
#include <string>

#include "tests/simulate/integrators/equations.h"

namespace pcm::simulate {
namespace {

class Refused : public EachMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, Refused, testing::ValuesIn(kMethods), test_name);

template <typename Function>
void expect_refused(const Function& function, const std::string& words) {
  try {
    function();
    ADD_FAILURE() << "not refused: " << words;
  } catch (const BadInput& refusal) {
    EXPECT_NE(std::string(refusal.what()).find(words), std::string::npos) << refusal.what();
  }
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST_P(Refused, AreTolerancesAndStepsThatMakeNoSense) {
  const auto expect_control_refused = [](const auto& change, const std::string& words) {
    StepControl control = tolerance(1e-6, 2);
    change(control);
    expect_refused([&] { (void)make_integrator(GetParam(), oscillator(), control); }, words);
  };
  for (const double wrong : {0., -1., kNaN}) {
    expect_control_refused([=](StepControl& c) { c.relative = wrong; }, "relative tolerance");
    expect_control_refused([=](StepControl& c) { c.absolute[1] = wrong; }, "absolute tolerance of component 1");
    expect_control_refused([=](StepControl& c) { c.greatest_step = wrong; }, "steps from");
  }
  expect_control_refused([](StepControl& c) { c.absolute.resize(3); }, "3 absolute tolerances for 2 components");
  expect_control_refused([](StepControl& c) { c.least_step = -1; }, "steps from");
  expect_control_refused([](StepControl& c) { c.least_step = 2, c.greatest_step = 1; }, "steps from");
  expect_control_refused([](StepControl& c) { c.most_steps = 0; }, "allow some");
}

TEST(RefusedBySimbody, AreRelativeTolerancesFromOneOn) {
  expect_refused([] { (void)make_integrator(Method::runge_kutta_merson, oscillator(), tolerance(1, 2)); },
                 "Simbody takes those below 1");
}

TEST_P(Refused, AreEquationsWithoutSizeOrDerivative) {
  expect_refused([] { (void)make_integrator(GetParam(), {2, {}, {}}, tolerance(1e-6, 2)); }, "no derivative");
  DifferentialEquation empty = oscillator();
  empty.size = 0;
  expect_refused([&] { (void)make_integrator(GetParam(), empty, tolerance(1e-6, 0)); }, "no components");
}

TEST_P(Refused, AreStartsAndEndsThatMakeNoSense) {
  const auto integrator = make_integrator(GetParam(), oscillator(), tolerance(1e-6, 2));
  expect_refused([&] { integrator->step(1); }, "no steps before a start");
  expect_refused([&] { integrator->start(0, vector({0})); }, "1 components, the equation 2");
  expect_refused([&] { integrator->start(0, vector({0, kNaN})); }, "component 1 of the initial state");
  expect_refused([&] { integrator->start(kNaN, vector({0, 1})); }, "not finite");
  integrator->start(1, vector({0, 1}));
  for (const double t_end : {0.5, 1., kNaN}) {
    expect_refused([&] { integrator->step(t_end); }, "a step from t = 1 s can't end at");
  }
  EXPECT_GT(integrator->step(2).t, 1);  // refusals leave no trace
}

TEST_P(Refused, AreTimesOutsideTheLastStep) {
  const auto integrator = make_integrator(GetParam(), oscillator(), tolerance(1e-6, 2));
  integrator->start(1, vector({0, 1}));
  EXPECT_EQ(integrator->state_at(1), vector({0, 1}));
  expect_refused([&] { (void)integrator->state_at(1.5); }, "is not to be had");
  integrator->step(2);
  integrator->step(2);
  expect_refused([&] { (void)integrator->state_at(1); }, "is not to be had");
  expect_refused([&] { (void)integrator->state_at(2.5); }, "is not to be had");
  EXPECT_EQ(integrator->state_at(integrator->t()), integrator->y());
}

TEST_P(Refused, AreDerivativesThatResizeTheirAnswer) {
  const auto resizing = everywhere(2, [](double, const Eigen::VectorXd&) { return vector({1, 2, 3}); });
  const auto integrator = make_integrator(GetParam(), resizing, tolerance(1e-6, 2));
  integrator->start(0, vector({0, 1}));
  expect_refused([&] { integrator->step(1); }, "was made 3 x 1, where 2 x 1 was asked for");
}

}  // namespace
}  // namespace pcm::simulate
