// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Simbody.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simulate/integrators/make_integrator.h"

/// libSimTKmath exports some hundred functions of an old SUNDIALS under the names of today's; either side crashes where
/// it gets the other's.
namespace {

constexpr double kLength = 0.5, kGravity = 9.81, kEnd = 2;

double angle_by_simbody() {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  const SimTK::Force::UniformGravity gravity(forces, matter, SimTK::Vec3(0, -kGravity, 0));
  const SimTK::Body::Rigid bob(SimTK::MassProperties(1, SimTK::Vec3(0), SimTK::Inertia(0)));
  SimTK::MobilizedBody::Pin pendulum(matter.Ground(), SimTK::Transform(SimTK::Vec3(0)), bob,
                                     SimTK::Transform(SimTK::Vec3(0, kLength, 0)));
  SimTK::State state = system.realizeTopology();
  pendulum.setAngle(state, 1);
  SimTK::CPodesIntegrator integrator(system, SimTK::CPodes::BDF, SimTK::CPodes::Newton);
  integrator.setAccuracy(1e-9);
  SimTK::TimeStepper stepper(system, integrator);
  stepper.initialize(state);
  stepper.stepTo(kEnd);
  return pendulum.getAngle(integrator.getState());
}

double angle_by_sundials(pcm::simulate::Method method) {
  pcm::simulate::DifferentialEquation equation;
  equation.size = 2;
  equation.derivative = [](double, const Eigen::VectorXd& y, Eigen::VectorXd& dydt) {
    dydt << y[1], -kGravity / kLength * std::sin(y[0]);
    return pcm::simulate::Evaluation::available;
  };
  pcm::simulate::StepControl control;
  control.relative = 1e-10;
  control.absolute = Eigen::Vector2d(1e-10, 1e-10);
  const auto integrator = make_integrator(method, equation, control);
  integrator->start(0, Eigen::Vector2d(1, 0));
  while (integrator->t() < kEnd) integrator->step(kEnd);
  return integrator->y()[0];
}

TEST(BesideSimbody, BothSundialsRunInOneProgram) {
  using pcm::simulate::Method;
  for (int round = 0; round < 2; ++round) {
    const double simbody = angle_by_simbody();
    for (const Method method : {Method::adams, Method::bdf, Method::ida, Method::dormand_prince, Method::esdirk,
                                Method::rkc, Method::runge_kutta_merson}) {
      EXPECT_NEAR(angle_by_sundials(method), simbody, 1e-6) << name(method);
    }
  }
}

}  // namespace
