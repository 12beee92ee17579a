// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What docs/slow_phase.md says of the scene `creep`.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "simulate/run/simulation.h"
#include "simulate/scenes/read_scene.h"
#include "tests/simulate/run/run_scene.h"

namespace pcm::simulate {
namespace {

constexpr double kMu = 0.5, kSlipVelocity = 1e-3, kTilt = 0.1, kGravity = 9.81;

Scene creep(Method method, double tolerance) {
  return built_in_scene_with("creep", method, tolerance);
}

struct Creep {
  Eigen::VectorXd y;
  std::vector<SimulatedStep> steps;
  std::int64_t derivatives = 0;  ///< those for Jacobians too
};

Creep run(const Scene& scene) {
  Simulation simulation(scene);
  simulation.start();
  Creep result;
  while (!simulation.finished()) result.steps.push_back(simulation.step());
  result.y = simulation.checkpoint().y;
  result.derivatives = simulation.work().derivatives + simulation.work().derivatives_for_jacobians;
  return result;
}

/// s = v / v_eps at which friction (20) holds the block: mu s (2 - s) = tan(tilt).
double creep_speed() {
  return 1 - std::sqrt(1 - std::tan(kTilt) / kMu);
}

// Sideways, friction is mu F_n v (2 - s) / v_eps, so a = mu g cos(tilt) (2 - s) / v_eps over the mass. It acts at the
// foot, r below the centre of mass, and so turns the block, which foundation and damping resist: with v and the roll
// phi, v' = -a (v + r phi'), I phi'' = -m a r (v + r phi') - D phi' - K phi.
// K and D are those of the whole foot, where contact has a few large elements, at whose centroids damping acts: that
// moves the eigenvalue, which is 9,519 / s without D and 9,589 / s with it, by a fraction of their difference.
TEST(SlowPhase, StiffestEigenvalueIsThatOfRegularisedFriction) {
  Scene scene = creep(Method::bdf, 1e-5);
  scene.output.spectrum_interval = 1;
  const Creep creeping = run(scene);
  const double normal_g = kGravity * std::cos(kTilt), m = 10, c = 1e6, d = 2e4;
  EXPECT_NEAR(creeping.y[10], creep_speed() * kSlipVelocity, 1e-7);
  const double a = kMu * normal_g * (2 - creep_speed()) / kSlipVelocity;
  const double r = 0.05 - m * normal_g / c / 2, I = m * (1 + 0.1 * 0.1) / 12;
  Eigen::Matrix3d motion;
  motion << -a, -a * r, 0, -m * a * r / I, -m * a * r * r / I - d / 12 / I, -c / 12 / I, 0, 1, 0;
  const double expected = motion.eigenvalues().real().minCoeff();
  ASSERT_TRUE(creeping.steps.back().spectrum.has_value());
  EXPECT_NEAR(creeping.steps.back().spectrum->least_real, expected, 20);
}

// The product of step and spectral radius is what the method can bear: 3.3 on the negative axis for Dormand and
// Prince's.
TEST(SlowPhase, ExplicitStepsAreThoseOfTheStabilityLimit) {
  Scene scene = creep(Method::dormand_prince, 1e-4);
  scene.duration = 2;
  scene.output.spectrum_interval = 20;
  const Creep explicit_run = run(scene);
  std::vector<double> products;
  for (const SimulatedStep& step : explicit_run.steps)
    if (step.spectrum && step.step.t > 0.5) products.push_back(step.step.size * step.spectrum->radius);
  ASSERT_GT(products.size(), 50U);
  std::sort(products.begin(), products.end());
  EXPECT_NEAR(products[products.size() / 2], 3.3, 0.4);
}

// Dormand and Prince's takes 6 evaluations for every 3.3 / |lambda|, RKC some 30 for its greatest step of 0.05 s.
TEST(SlowPhase, TheStabilisedExplicitMethodTakesAnEighthOfTheEvaluationsAndIsMoreAccurate) {
  Scene scene = creep(Method::dormand_prince, 1e-4);
  scene.duration = 2;
  const Creep explicit_run = run(scene);
  scene.integrator.method = Method::rkc;
  const Creep stabilised = run(scene);
  EXPECT_LT(8 * stabilised.derivatives, explicit_run.derivatives);
  EXPECT_NEAR(stabilised.y[10], creep_speed() * kSlipVelocity, 1e-7);
}

TEST(SlowPhase, ImplicitMethodsTakeATwentiethOfTheEvaluationsAndAreAsAccurate) {
  const auto run_for_2_s = [](Method method, double tolerance) {
    Scene scene = creep(method, tolerance);
    scene.duration = 2;
    return run(scene);
  };
  const Creep reference = run_for_2_s(Method::bdf, 1e-6);
  const Creep explicit_run = run_for_2_s(Method::dormand_prince, 1e-4);
  for (const Method method : {Method::bdf, Method::ida, Method::esdirk}) {
    const Creep implicit = run_for_2_s(method, 1e-4);
    EXPECT_LT(20 * implicit.derivatives, explicit_run.derivatives) << name(method);
    // Where it lies, and where it lies at a hundredth of the tolerance.
    EXPECT_NEAR(implicit.y[4], reference.y[4], 5e-4) << name(method);
    EXPECT_NEAR(implicit.y[10], reference.y[10], 1e-4) << name(method);
  }
}

}  // namespace
}  // namespace pcm::simulate
