// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "meshes/generate/boxes.h"
#include "pcm/simbody.h"

namespace pcm::simbody {
namespace {

constexpr Wanted kElements{false, false, true, true, false, false};

double energy_of(const fast::Pairing& pairing, const Pose& pose) {
  fast::Workspace workspace;
  return elastic_energy(pairing, pose, fast::evaluate(pairing, pose, Velocity(), kElements, workspace));
}

/// A plate below, a block of 1 m x 1 m on it. Contact area 1 m^2.
fast::Pairing block_on_plate(const ContactLaw& law, Mode mode, Scheme scheme) {
  return fast::Pairing(fast::Surface(generate::plate(3, 3, 1)), fast::Surface(generate::box({1, 1, 1})), law, mode,
                       scheme);
}

Pose sunk(double depth) {
  Pose pose;
  pose.r = {0.03, 0.02, 0.5 - depth};
  return pose;
}

// c A u^2 / 2, u the same everywhere: 1e6 N/m^3, 1 m^2, 1 mm.
TEST(ElasticEnergy, OfAFlatBlockIsThatOfASpring) {
  ContactLaw law;
  law.stiffness = 1e6;
  EXPECT_NEAR(energy_of(block_on_plate(law, Mode::F, Scheme::barycentric), sunk(1e-3)), 0.5, 1e-12);
  for (const Mode mode : {Mode::E, Mode::F, Mode::both})
    EXPECT_NEAR(energy_of(block_on_plate(law, mode, Scheme::clipped), sunk(1e-3)), 0.5, 1e-12);
}

TEST(ElasticEnergy, OfLayersInSeriesIsThatOfTheirSpring) {
  ContactLaw law;
  law.layers = LayerStiffness{3e6, 1.5e6};  // 1e6 together
  for (const Mode mode : {Mode::E, Mode::F})
    EXPECT_NEAR(energy_of(block_on_plate(law, mode, Scheme::clipped), sunk(1e-3)), 0.5, 1e-12);
}

TEST(ElasticEnergy, OfALayerOnARigidBodyIsThatOfTheLayer) {
  ContactLaw law;
  const double rigid = std::numeric_limits<double>::infinity();
  for (const LayerStiffness& layers : {LayerStiffness{1e6, rigid}, LayerStiffness{rigid, 1e6}}) {
    law.layers = layers;
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped})
      EXPECT_NEAR(energy_of(block_on_plate(law, Mode::F, scheme), sunk(1e-3)), 0.5, 1e-12);
  }
}

// A block tilted about an edge line: u = h - x tan(t) over the plate, from 0 to its greatest value, on the width w = 1.
// Plate as master: E = c w int u^2 / 2 dx = c w u_max^3 / (6 tan t), u measured along the plate's normal.
TEST(ElasticEnergy, OfATiltedBlockIsTheIntegralOfTheSquaredDepth) {
  ContactLaw law;
  law.stiffness = 1e6;
  const double tilt = 0.05, deepest = 2e-3;
  Pose pose;
  pose.A = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY()).toRotationMatrix();
  // The corner line (0.5, *, -0.5) of the block is the lowest; it lies `deepest` below z = 0.
  pose.r = {0.02, 0.01, deepest - (pose.A * Eigen::Vector3d(0.5, 0, -0.5)).z() - 2 * deepest};
  // To the right of the lowest line the block's side rises at 1 / tan(t): u falls from its greatest value to 0 there.
  const double slope = std::tan(tilt);
  const double cube = deepest * deepest * deepest;
  const double expected = 1e6 * (cube / (6 * slope) + cube * slope / 6);
  EXPECT_NEAR(energy_of(block_on_plate(law, Mode::E, Scheme::clipped), pose), expected, 1e-9 * expected);
  // However the layers share the depth, which moves the elements' positions.
  const double rigid = std::numeric_limits<double>::infinity();
  for (const LayerStiffness& layers : {LayerStiffness{5e6, 1.25e6}, LayerStiffness{1.25e6, 5e6},
                                       LayerStiffness{1e6, rigid}, LayerStiffness{rigid, 1e6}}) {
    law.layers = layers;
    EXPECT_NEAR(energy_of(block_on_plate(law, Mode::E, Scheme::clipped), pose), expected, 1e-9 * expected);
  }
}

// The depth that the engine publishes is clamped: the energy then is a lower bound of that of the clamped depth.
TEST(ElasticEnergy, OfClampedDepthsCountsThemAsClamped) {
  ContactLaw law;
  law.stiffness = 1e6;
  law.max_penetration = 5e-4;
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped})
    EXPECT_NEAR(energy_of(block_on_plate(law, Mode::F, scheme), sunk(1e-3)), 0.125, 1e-12);
}

// A block falls on a plate and comes back, undamped: kinetic, gravity's and elastic energy together stay what they are.
TEST(ElasticEnergy, IsWhatSimbodyCountsAsPotentialEnergy) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  const SimTK::Force::UniformGravity gravity(forces, matter, SimTK::Vec3(0, 0, -9.81));
  ContactForces contact(forces, matter);
  const SimTK::Body::Rigid body(SimTK::MassProperties(1000, SimTK::Vec3(0), SimTK::Inertia(200)));
  SimTK::MobilizedBody::Free block(matter.Ground(), body);
  const Index plate = contact.add_surface(matter.Ground(), SimTK::Transform(), fast::Surface(generate::plate(3, 3, 1)));
  const Index on_block = contact.add_surface(block, SimTK::Transform(), fast::Surface(generate::box({1, 1, 1})));
  ContactLaw law;
  law.stiffness = 1e6;
  contact.add_pairing(plate, on_block, law, Mode::E, Scheme::clipped);
  SimTK::State state = system.realizeTopology();
  block.setQToFitTranslation(state, SimTK::Vec3(0.03, 0.02, 0.7));
  system.realize(state, SimTK::Stage::Dynamics);
  const double before = system.calcEnergy(state);

  SimTK::RungeKuttaMersonIntegrator integrator(system);
  integrator.setAccuracy(1e-8);
  integrator.setMaximumStepSize(1e-2);
  SimTK::TimeStepper stepper(system, integrator);
  stepper.initialize(state);
  double most_elastic = 0, highest_after = 0;
  for (int i = 1; i <= 60; ++i) {
    stepper.stepTo(0.01 * i);
    const SimTK::State& now = stepper.getState();
    system.realize(now, SimTK::Stage::Dynamics);
    EXPECT_NEAR(system.calcEnergy(now), before, 1e-5 * before) << now.getTime();
    most_elastic = std::max(most_elastic, contact.elastic_energy(now));
    if (i > 40) highest_after = std::max(highest_after, block.getBodyOriginLocation(now)[2]);
  }
  EXPECT_GT(most_elastic, 0.2 * 1000 * 9.81 * 0.2);
  EXPECT_GT(highest_after, 0.6);
}

}  // namespace
}  // namespace pcm::simbody
