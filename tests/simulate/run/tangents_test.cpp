// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Jacobians from tangents of the pairings, beside those by differences that ask the engine in every column.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "simulate/integrators/difference_quotients.h"
#include "tests/simulate/run/run_scene.h"

namespace pcm::simulate {
namespace {

struct Jacobians {
  Eigen::MatrixXd by_differences, by_tangents;

  double distance() const { return (by_tangents - by_differences).norm() / by_differences.norm(); }
};

/// Differences are over `change` m, rad, m/s and rad/s.
Jacobians jacobians(const Scene& scene, const Eigen::VectorXd& y, double change) {
  Model model(scene);
  const Eigen::Index n = model.size();
  const Eigen::VectorXd absolute = Eigen::VectorXd::Constant(n, 10 * change);
  Eigen::VectorXd dydt(n);
  EXPECT_EQ(model.derivative(0, y, dydt), Evaluation::available);
  Jacobians result{Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, n)};
  const auto derivative = [&](double t, const Eigen::VectorXd& at, Eigen::VectorXd& slope) {
    return model.derivative(t, at, slope);
  };
  const auto linear_derivative = [&](double t, const Eigen::VectorXd& at, Eigen::VectorXd& slope) {
    model.linear_derivative(t, at, slope);
    return Evaluation::available;
  };
  const TangentCost cost = model.linearise(0, y);
  EXPECT_TRUE(cost.exists);
  EXPECT_EQ(cost.evaluations, 1);
  EXPECT_EQ(difference_quotients(linear_derivative, absolute, 0, y, dydt, result.by_tangents), Evaluation::available);
  EXPECT_EQ(difference_quotients(derivative, absolute, 0, y, dydt, result.by_differences), Evaluation::available);
  return result;
}

/// One in the clipped scheme, whose forces have no jumps.
Scene smooth(const std::string& name) {
  Scene scene = built_in_scene_with(name, Method::bdf, 1e-6);
  for (ScenePairing& pairing : scene.pairings) pairing.scheme = Scheme::clipped;
  return scene;
}

/// The state when `t` is reached.
Eigen::VectorXd state_at(Scene scene, double t) {
  scene.duration = t;
  return end_of(scene);
}

// Differences are off by the order of the increment: a tenth at a tenth.
TEST(Tangents, HaveTheJacobianOfDifferencesToFirstOrder) {
  for (const auto& [name, t] : {std::pair<std::string, double>{"creep", 0.3}, {"bubbles", 0.5}}) {
    SCOPED_TRACE(name + " at " + std::to_string(t));
    const Scene scene = smooth(name);
    const Eigen::VectorXd y = state_at(scene, t);
    const double coarse = jacobians(scene, y, 1e-5).distance(), fine = jacobians(scene, y, 1e-6).distance();
    EXPECT_LT(coarse, 0.02);
    EXPECT_NEAR(coarse / fine, 10, 3);
  }
}

struct FinishedRun {
  Work work;
  std::int64_t law_only;
  Eigen::VectorXd y;
};

FinishedRun run_by(Scene scene, JacobianOf jacobian) {
  scene.integrator.jacobian = jacobian;
  Simulation simulation(scene);
  simulation.start();
  while (!simulation.finished()) simulation.step();
  return {simulation.work(), simulation.law_only(), simulation.checkpoint().y};
}

TEST(Tangents, AskTheEngineOnceForAJacobianAndInNoColumn) {
  for (const Method method : {Method::bdf, Method::ida, Method::esdirk}) {
    SCOPED_TRACE(name(method));
    Scene creep = built_in_scene_with("creep", method, 1e-4);
    creep.duration = 0.5;
    const FinishedRun run = run_by(creep, JacobianOf::tangents);
    ASSERT_GE(run.work.jacobians, 2);
    EXPECT_EQ(run.work.derivatives_for_jacobians, run.work.jacobians);
    EXPECT_EQ(run.law_only, 0);
    EXPECT_EQ(run.work.linear_derivatives, 13 * run.work.jacobians);
    const FinishedRun by_differences = run_by(creep, JacobianOf::differences);
    EXPECT_EQ(by_differences.work.linear_derivatives, 0);
    EXPECT_EQ(by_differences.work.derivatives_for_jacobians, 13 * by_differences.work.jacobians);
    // The same motion, to the tolerance.
    EXPECT_LT((run.y - by_differences.y).cwiseAbs().maxCoeff(), 5e-4);
  }
}

// In flight nothing touches, and nothing is asked.
TEST(Tangents, OfBodiesApartCostNothing) {
  Scene scene = built_in_scene_with("bubbles", Method::bdf, 1e-4);
  scene.duration = 0.05;
  const FinishedRun run = run_by(scene, JacobianOf::tangents);
  EXPECT_GE(run.work.jacobians, 1);
  EXPECT_EQ(run.work.derivatives_for_jacobians, 0);
  EXPECT_EQ(run.work.linear_derivatives, 39 * run.work.jacobians);
}

TEST(Tangents, DoNotExistWhereBodiesAreTooDeep) {
  Scene scene = smooth("creep");
  const Eigen::VectorXd y = state_at(scene, 0.3);
  const double depth = Model(scene).observe(0, y).pairings[0].max_penetration;
  for (const bool too_deep : {false, true}) {
    scene.pairings[0].law.max_penetration = depth * (too_deep ? 1 - 1e-7 : 1 + 1e-7);
    EXPECT_EQ(Model(scene).linearise(0, y).exists, !too_deep);
  }
}

}  // namespace
}  // namespace pcm::simulate
