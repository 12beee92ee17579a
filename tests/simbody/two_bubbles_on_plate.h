// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "pcm/simbody.h"
#include "simbody/placed_surfaces.h"
#include "tests/simbody/rough_law.h"

namespace pcm::simbody {

using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::Vec3;

/// Two bubbles and a plate, each surface off its body's origin and turned, so that no frame is another one. The upper
/// bubble is on the plate in the clipped scheme.
struct TwoBubblesOnPlate {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  ContactForces contact{forces, matter};
  SimTK::MobilizedBody::Free lower, upper;
  const Transform X_GP{SimTK::Rotation(0.1, SimTK::XAxis), Vec3(0.02, 0.01, -0.05)};
  const Transform X_BS{SimTK::Rotation(0.4, SimTK::UnitVec3(1, 2, 3)), Vec3(0.1, -0.05, 0.2)};
  SimTK::State state;

  explicit TwoBubblesOnPlate(Scheme scheme = Scheme::barycentric) {
    const SimTK::Body::Rigid body(SimTK::MassProperties(2, Vec3(0), SimTK::Inertia(0.02)));
    lower = SimTK::MobilizedBody::Free(matter.Ground(), Transform(Vec3(0.3, 0.2, 0.1)), body, Transform());
    upper = SimTK::MobilizedBody::Free(matter.Ground(), body);
    const fast::Surface bubble(generate::bubble());
    const Index on_ground = contact.add_surface(matter.Ground(), X_GP, fast::Surface(generate::plate(2, 2, 0.5, 8, 8)));
    const Index on_lower = contact.add_surface(lower, X_BS, bubble);
    const Index on_upper = contact.add_surface(upper, Transform(), bubble);
    contact.add_pairing(on_ground, on_lower, rough(), Mode::F, scheme);
    contact.add_pairing(on_lower, on_upper, rough(), Mode::both, scheme);
    contact.add_pairing(on_upper, on_ground, rough(), Mode::E, Scheme::clipped);
    state = system.realizeTopology();
    const Transform X_GL(SimTK::Rotation(0.7, SimTK::UnitVec3(1, -1, 0.5)), Vec3(0.05, 0.1, -0.1));
    lower.setQToFitTransform(state, lower.getInboardFrame(state).invert() * X_GL);
    upper.setQToFitTransform(state, Transform(SimTK::Rotation(-0.4, SimTK::UnitVec3(0, 1, 1)), Vec3(0.2, 0.05, -0.08)));
    lower.setUToFitVelocity(state, SpatialVec(Vec3(1, -2, 0.5), Vec3(0.3, 0.2, -0.4)));
    upper.setUToFitVelocity(state, SpatialVec(Vec3(-0.5, 0.25, 1), Vec3(0, -0.1, -0.6)));
    system.realize(state, SimTK::Stage::Velocity);
  }

  /// By body, about its origin, in Ground.
  SimTK::Vector_<SpatialVec> body_forces(const SimTK::State& at) const {
    SimTK::Vector_<SpatialVec> bodies;
    SimTK::Vector_<Vec3> particles;
    SimTK::Vector mobilities;
    contact.calcForceContribution(at, bodies, particles, mobilities);
    return bodies;
  }
};

}  // namespace pcm::simbody
