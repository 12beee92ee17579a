// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A bubble falls on another one that is fixed, in Simbody.
#include <pcm/read_mesh.h>
#include <pcm/simbody.h>

#include <cstdio>

int main(int, char** argv) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  SimTK::Force::UniformGravity gravity(forces, matter, SimTK::Vec3(0, 0, -9.81));
  SimTK::MobilizedBody::Free ball(matter.Ground(),
                                  SimTK::Body::Rigid(SimTK::MassProperties(2, SimTK::Vec3(0), SimTK::Inertia(0.02))));

  const pcm::fast::Surface bubble(pcm::read_mesh(argv[1]));
  pcm::ContactLaw law;
  law.stiffness = 5.9e5;
  law.damping = 1000;
  law.transition_depth = 1e-3;
  pcm::simbody::ContactForces contact(forces, matter);
  const pcm::Index below = contact.add_surface(matter.Ground(), SimTK::Transform(), bubble);
  const pcm::Index above = contact.add_surface(ball, SimTK::Transform(), bubble);
  contact.add_pairing(below, above, law, pcm::Mode::both);

  SimTK::State state = system.realizeTopology();
  ball.setQToFitTranslation(state, SimTK::Vec3(0.01, 0.02, 0.5));
  SimTK::RungeKuttaMersonIntegrator integrator(system);
  integrator.setMaximumStepSize(5e-3);
  SimTK::TimeStepper stepper(system, integrator);
  stepper.initialize(state);
  double highest_force = 0;
  for (int i = 1; i <= 60; ++i) {
    stepper.stepTo(0.005 * i);
    system.realize(stepper.getState(), SimTK::Stage::Velocity);
    highest_force = std::max(highest_force, contact.answers(stepper.getState())[0].force_G.norm());
  }
  std::printf("it bounced: %s\n", highest_force > 100 ? "yes" : "no");
}
