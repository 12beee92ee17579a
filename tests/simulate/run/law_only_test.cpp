// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Difference quotients ask the engine for the law only where nothing but velocities changes, and no bit tells.
#include <gtest/gtest.h>

#include <string>

#include "simulate/integrators/make_integrator.h"
#include "simulate/run/simulation.h"
#include "simulate/scenes/read_scene.h"
#include "tests/simulate/scenes/built_in_scene.h"

namespace pcm::simulate {
namespace {

/// One of the built-in scenes, without checkpoints on the way.
Scene short_scene(const std::string& name, Method method, double duration) {
  Scene scene = built_in_scene(name);
  scene.integrator.method = method;
  scene.duration = scene.output.checkpoint_interval = duration;
  return scene;
}

/// The same run, in which everything is found anew at every state.
struct Forgetful {
  Model model;
  std::unique_ptr<Integrator> integrator;

  explicit Forgetful(const Scene& scene) : model(scene) {
    DifferentialEquation equation;
    equation.size = model.size();
    equation.derivative = [this](double t, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
      return model.derivative(t, y, dydt);
    };
    StepControl control;
    control.relative = scene.integrator.relative_tolerance;
    control.absolute = Eigen::VectorXd::Constant(model.size(), scene.integrator.absolute_tolerance);
    control.greatest_step = scene.integrator.greatest_step;
    integrator = make_integrator(scene.integrator.method, equation, control);
    integrator->start(0, model.normalised(model.start()));
  }
};

/// `speeds`: columns of a Jacobian that change velocities only.
void expect_same_run(const Scene& scene, std::int64_t speeds) {
  Simulation simulation(scene);
  simulation.start();
  Forgetful forgetful(scene);
  while (!simulation.finished()) {
    const SimulatedStep step = simulation.step();
    ASSERT_EQ(step.step.t, forgetful.integrator->step(scene.duration).t);
    ASSERT_EQ(simulation.checkpoint().y, forgetful.integrator->y());
  }
  const Work &work = simulation.work(), &work_of_forgetful = forgetful.integrator->work();
  EXPECT_EQ(work.derivatives, work_of_forgetful.derivatives);
  EXPECT_EQ(work.derivatives_for_jacobians, work_of_forgetful.derivatives_for_jacobians);
  EXPECT_EQ(work.jacobians, work_of_forgetful.jacobians);
  EXPECT_GE(work.jacobians, 2);
  // Beside these columns a solver may ask once more about the state itself; in no column of a coordinate.
  EXPECT_GE(simulation.law_only(), speeds * work.jacobians);
  EXPECT_LE(simulation.law_only(), speeds * work.jacobians + work.derivatives);
  EXPECT_EQ(forgetful.model.counters().law_only, 0);
}

TEST(LawOnly, InTheColumnsOfSpeedsOfAJacobianAndTheRunHasTheSameBits) {
  for (const Method method : {Method::bdf, Method::ida, Method::esdirk}) {
    SCOPED_TRACE(name(method));
    expect_same_run(short_scene("creep", method, 0.4), 6);
    expect_same_run(short_scene("bubbles", method, 0.6), 18);
  }
}

TEST(LawOnly, NeverInExplicitRuns) {
  Simulation simulation(short_scene("creep", Method::dormand_prince, 0.05));
  simulation.start();
  while (!simulation.finished()) simulation.step();
  EXPECT_EQ(simulation.law_only(), 0);
}

}  // namespace
}  // namespace pcm::simulate
