// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include "tests/simulate/integrators/equations.h"

namespace pcm::simulate {
namespace {

class Restart : public EachMethod {};
INSTANTIATE_TEST_SUITE_P(Methods, Restart, testing::ValuesIn(kMethods), test_name);

/// Mildly stiff, nonlinear, with a kink and with states that are not to be had: all that leaves traces in an
/// integrator.
DifferentialEquation rough() {
  return {2,
          [](double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
            dydt = vector({y[1], -100 * std::sin(y[0]) - 20 * y[1] * std::abs(y[1]) + (std::fmod(t, 0.3) > 0.2)});
            return y[0] > 1.05 ? Evaluation::not_here : Evaluation::available;
          },
          {}};
}

std::vector<Eigen::VectorXd> states(Integrator& integrator, double t_end) {
  std::vector<Eigen::VectorXd> all;
  run(integrator, t_end, [&](const Step& step) {
    all.push_back(integrator.y());
    all.push_back(integrator.state_at(step.t - step.size / 2));
  });
  return all;
}

TEST_P(Restart, ContinuesWithTheBitsOfAFreshIntegrator) {
  const StepControl control = tolerance(1e-5, 2);
  const auto used = make_integrator(GetParam(), rough(), control);
  used->start(0, vector({1, 1}));
  run(*used, 0.7);
  const Eigen::VectorXd checkpoint = used->y();
  used->start(0.7, checkpoint);
  const std::vector<Eigen::VectorXd> continued = states(*used, 2);

  const auto fresh = make_integrator(GetParam(), rough(), control);
  fresh->start(0.7, checkpoint);
  const std::vector<Eigen::VectorXd> anew = states(*fresh, 2);
  ASSERT_GT(anew.size(), 20U);
  EXPECT_EQ(continued, anew);
}

TEST_P(Restart, AfterAFailureToo) {
  StepControl control = tolerance(1e-5, 2);
  control.most_steps = 30;
  const auto used = make_integrator(GetParam(), rough(), control);
  used->start(0, vector({1, 1}));
  EXPECT_THROW(run(*used, 100), IntegrationFailure);
  const auto fresh = make_integrator(GetParam(), rough(), control);
  for (Integrator* integrator : {used.get(), fresh.get()}) integrator->start(3, vector({0.5, -1}));
  EXPECT_EQ(states(*used, 3.01), states(*fresh, 3.01));
}

}  // namespace
}  // namespace pcm::simulate
