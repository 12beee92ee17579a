// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "pcm/bad_input.h"
#include "pcm/scene.h"
#include "tests/simbody/two_bubbles_on_plate.h"

namespace pcm::simbody {
namespace {

/// The engine's own scene, placed by hand: x_G = R_GB (R_BS x + p_BS) + p_GB and its derivative.
fast::Scene by_hand(const TwoBubblesOnPlate& model) {
  fast::Scene scene;
  const fast::Surface bubble(generate::bubble());
  scene.add_body(fast::Surface(generate::plate(2, 2, 0.5, 8, 8)));
  scene.add_body(bubble);
  scene.add_body(bubble);
  scene.add_pairing(0, 1, rough(), Mode::F);
  scene.add_pairing(1, 2, rough(), Mode::both);
  scene.add_pairing(2, 0, rough(), Mode::E, Scheme::clipped);
  const auto placed = [&](const SimTK::MobilizedBody& body, const Transform& X_BS) {
    const Transform X = body.getBodyTransform(model.state) * X_BS;
    fast::BodyState state;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) state.pose.A(i, j) = X.R().asMat33()(i, j);
    state.pose.r = to_eigen(X.p());
    const SpatialVec V = body.getBodyVelocity(model.state);
    state.velocity.w = to_eigen(V[0]);
    state.velocity.v = to_eigen(V[1] + V[0] % (X.p() - body.getBodyOriginLocation(model.state)));
    return state;
  };
  scene.move({placed(model.matter.getGround(), model.X_GP), placed(model.lower, model.X_BS),
              placed(model.upper, Transform())});
  return scene;
}

TEST(ContactForces, EveryBodyFeelsTheEnginesLoadAboutItsOwnOrigin) {
  const TwoBubblesOnPlate model;
  fast::Scene scene = by_hand(model);
  scene.evaluate_all();
  const std::vector<fast::BodyLoad> loads = scene.body_loads();
  const SimTK::Vector_<SpatialVec> forces = model.body_forces(model.state);
  const auto expect_load = [&](const SimTK::MobilizedBody& body, const fast::BodyLoad& load, const Vec3& origin_S) {
    const SpatialVec& F = forces[body.getMobilizedBodyIndex()];
    const double size = load.force_W.norm();
    ASSERT_GT(size, 1);
    EXPECT_LT((to_eigen(F[1]) - load.force_W).norm(), 1e-12 * size);
    const Eigen::Vector3d arm = to_eigen(origin_S - body.getBodyOriginLocation(model.state));
    EXPECT_LT((to_eigen(F[0]) - load.torque_W - arm.cross(load.force_W)).norm(), 1e-12 * size);
  };
  expect_load(model.lower, loads[1], (model.lower.getBodyTransform(model.state) * model.X_BS).p());
  expect_load(model.upper, loads[2], model.upper.getBodyOriginLocation(model.state));
  expect_load(model.matter.getGround(), loads[0], model.X_GP.p());
}

TEST(ContactForces, AreInternalForces) {
  const TwoBubblesOnPlate model;
  const SimTK::Vector_<SpatialVec> forces = model.body_forces(model.state);
  Vec3 force(0), torque(0);
  double size = 0;
  for (SimTK::MobilizedBodyIndex b(0); b < model.matter.getNumBodies(); ++b) {
    force += forces[b][1];
    torque += forces[b][0] + model.matter.getMobilizedBody(b).getBodyOriginLocation(model.state) % forces[b][1];
    size += forces[b][1].norm();
  }
  EXPECT_LT(force.norm(), 1e-14 * size);
  EXPECT_LT(torque.norm(), 1e-14 * size);
}

TEST(ContactForces, AnswersAreTheEnginesContacts) {
  const TwoBubblesOnPlate model;
  for (Index p = 0; p < model.contact.pairings(); ++p) {
    const PairingAnswer& answer = model.contact.answers(model.state)[static_cast<std::size_t>(p)];
    const fast::Contact contact = model.contact.contact(model.state, p);
    ASSERT_TRUE(contact.touching) << p;
    EXPECT_TRUE(answer.touching);
    EXPECT_EQ(answer.nested, contact.nested);
    EXPECT_EQ(answer.ambiguous, contact.ambiguous);
    EXPECT_EQ(answer.penetration_exceeded, contact.penetration_exceeded);
    EXPECT_EQ(answer.elements, static_cast<Index>(contact.elements.size()));
    EXPECT_EQ(answer.too_deep, contact.too_deep);
    EXPECT_EQ(answer.max_penetration, contact.max_penetration);
    EXPECT_NEAR(answer.force_G.norm(), contact.force_Me.norm(), 1e-13 * contact.force_Me.norm());
  }
}

TEST(ContactForces, VisitedElementsAreThoseOfEachContact) {
  const TwoBubblesOnPlate model;
  Index visited = 0;
  std::vector<Pose> poses;
  std::vector<Velocity> velocities;
  model.contact.visit_elements(model.state,
                               [&](Index p, const Pose& pose, const Velocity& velocity, const fast::Contact& contact) {
                                 EXPECT_EQ(p, visited++);
                                 poses.push_back(pose);
                                 velocities.push_back(velocity);
                                 EXPECT_EQ(static_cast<Index>(contact.elements.size()), contact.element_count);
                                 EXPECT_GT(contact.element_count, 0);
                               });
  ASSERT_EQ(visited, 3);
  for (Index p = 0; p < visited; ++p) {
    EXPECT_EQ(poses[static_cast<std::size_t>(p)].r, model.contact.relative_pose(model.state, p).r);
    EXPECT_EQ(velocities[static_cast<std::size_t>(p)].w, model.contact.relative_velocity(model.state, p).w);
  }
}

bool same_bits(const SimTK::Vector_<SpatialVec>& a, const SimTK::Vector_<SpatialVec>& b) {
  for (int i = 0; i < a.size(); ++i)
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 3; ++j)
        if (!(a[i][k][j] == b[i][k][j])) return false;
  return a.size() == b.size();
}

TEST(ContactForces, AreAFunctionOfTheStateAlone) {
  const TwoBubblesOnPlate model;
  const SimTK::Vector_<SpatialVec> first = model.body_forces(model.state);
  SimTK::State elsewhere = model.state;
  for (double away : {0.01, 0.4, 3.0}) {
    elsewhere.updQ()[6] += away;
    model.system.realize(elsewhere, SimTK::Stage::Velocity);
    EXPECT_FALSE(same_bits(model.body_forces(elsewhere), first)) << away;
    SimTK::State back = elsewhere;
    back.updQ() = model.state.getQ();
    model.system.realize(back, SimTK::Stage::Velocity);
    EXPECT_TRUE(same_bits(model.body_forces(back), first)) << away;
  }
}

// In one and the same State, whose cache must notice.
TEST(ContactForces, FollowAChangeOfSpeedsAlone) {
  const TwoBubblesOnPlate model, other;
  SimTK::State state = model.state;
  model.system.realize(state, SimTK::Stage::Velocity);
  const SimTK::Vector_<SpatialVec> first = model.body_forces(state);
  state.updU()[3] += 0.1;
  model.system.realize(state, SimTK::Stage::Velocity);
  const SimTK::Vector_<SpatialVec> faster = model.body_forces(state);
  EXPECT_FALSE(same_bits(faster, first));
  SimTK::State fresh = other.state;
  fresh.updU() = state.getU();
  other.system.realize(fresh, SimTK::Stage::Velocity);
  EXPECT_TRUE(same_bits(faster, other.body_forces(fresh)));
}

TEST(ContactForces, AskTheEngineOnceForEachState) {
  const TwoBubblesOnPlate model;
  model.body_forces(model.state);
  model.body_forces(model.state);
  model.contact.answers(model.state);
  EXPECT_EQ(model.contact.counters().states, 1);
  EXPECT_EQ(model.contact.counters().evaluated, 3);
}

// Differences for a Jacobian: the columns of the upper bubble leave the lower one on the plate alone.
TEST(ContactForces, RememberedAnswersHaveTheSameBits) {
  const TwoBubblesOnPlate model, forgetful;
  model.contact.remember(model.state);
  const ContactCounters before = model.contact.counters();
  for (const bool velocities : {false, true}) {
    for (int i = 0; i < (velocities ? model.state.getNU() : model.state.getNQ()); ++i) {
      SimTK::State moved = model.state;
      double& coordinate = velocities ? moved.updU()[i] : moved.updQ()[i];
      coordinate += 1e-6;
      model.system.realize(moved, SimTK::Stage::Velocity);
      SimTK::State other = forgetful.state;
      other.updQ() = moved.getQ();
      other.updU() = moved.getU();
      forgetful.system.realize(other, SimTK::Stage::Velocity);
      EXPECT_TRUE(same_bits(model.body_forces(moved), forgetful.body_forces(other))) << velocities << i;
    }
  }
  // 7 coordinates and 6 speeds of each body; each moves two of three pairings.
  const ContactCounters after = model.contact.counters();
  EXPECT_EQ(after.recalled, 26);
  EXPECT_EQ(after.evaluated - before.evaluated, 52);
  EXPECT_EQ(after.law_only, 24);
  EXPECT_EQ(after.unmoved, 12);
}

// The states asked for may come in any order, and what is remembered last counts.
TEST(ContactForces, OtherVelocitiesHaveTheSameBitsWhateverCameBefore) {
  const TwoBubblesOnPlate model, forgetful;
  SimTK::State elsewhere = model.state;
  elsewhere.updQ()[5] += 1e-3;
  elsewhere.updQ()[12] += 2e-3;
  for (int k = 0; k < 12; ++k) {
    SimTK::State state = k % 3 == 0 ? elsewhere : model.state;
    state.updU()[k] *= -2;
    if (k == 4) state.updU() = 0;
    model.system.realize(state, SimTK::Stage::Velocity);
    SimTK::State other = forgetful.state;
    other.updQ() = state.getQ();
    other.updU() = state.getU();
    forgetful.system.realize(other, SimTK::Stage::Velocity);
    if (k % 5 == 1) model.contact.remember(state);
    EXPECT_TRUE(same_bits(model.body_forces(state), forgetful.body_forces(other))) << k;
  }
  // Remembered are states 1, 6 and 11. Two pairings move otherwise at 2, 5 and 9, and all at 4; at others they are
  // elsewhere.
  EXPECT_EQ(model.contact.counters().law_only, 9);
  model.contact.forget();
  const std::int64_t unmoved = model.contact.counters().unmoved;
  SimTK::State again = model.state;
  again.updU() = model.state.getU();
  model.system.realize(again, SimTK::Stage::Velocity);
  EXPECT_TRUE(same_bits(model.body_forces(again), forgetful.body_forces(forgetful.state)));
  EXPECT_EQ(model.contact.counters().unmoved, unmoved);
}

// Remembered at one state, then at another one: the first is forgotten.
TEST(ContactForces, RememberTheLastStateOnly) {
  const TwoBubblesOnPlate model, forgetful;
  model.contact.remember(model.state);
  SimTK::State moved = model.state;
  moved.updQ()[5] += 1e-3;
  moved.updQ()[12] += 1e-3;
  model.system.realize(moved, SimTK::Stage::Velocity);
  model.contact.remember(moved);
  const std::int64_t before = model.contact.counters().recalled;
  SimTK::State back = moved;
  back.updQ() = model.state.getQ();
  model.system.realize(back, SimTK::Stage::Velocity);
  EXPECT_TRUE(same_bits(model.body_forces(back), forgetful.body_forces(forgetful.state)));
  EXPECT_EQ(model.contact.counters().recalled, before);
}

/// Two surfaces that stay where they are, F shifted.
struct TwoOnGround {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  ContactForces contact{forces, matter};
  SimTK::State state;

  TwoOnGround(const TriangleMesh& E, const TriangleMesh& F, const Vec3& p_GF, const ContactLaw& law = {}) {
    contact.add_surface(matter.Ground(), Transform(), fast::Surface(E));
    contact.add_surface(matter.Ground(), Transform(p_GF), fast::Surface(F));
    contact.add_pairing(0, 1, law);
    state = system.realizeTopology();
    system.realize(state, SimTK::Stage::Velocity);
  }
  const PairingAnswer& answer() const { return contact.answers(state).front(); }
};

TEST(ContactForces, SayWhereAnOpenSurfaceLeavesFacesAmbiguous) {
  // The rectangle's border ends within a wall of the box.
  const TwoOnGround model(generate::rectangle(1, 1), generate::box({-4, -4, -4}, {0, 4, 4}),
                          Vec3(0.125, 0.0625, 0.03125));
  EXPECT_TRUE(model.answer().touching);
  EXPECT_TRUE(model.answer().ambiguous);
}

TEST(ContactForces, HaveNoTangentsForNestedBodiesOrBeyondTheGreatestPenetration) {
  const TriangleMesh box = generate::box({1, 1, 1});
  const TwoOnGround nested(generate::box({4, 4, 4}), box, Vec3(1, 1, 1));
  EXPECT_TRUE(nested.answer().nested);
  EXPECT_FALSE(nested.contact.tangents(nested.state).complete);
  ContactLaw law;
  law.max_penetration = 0.125;
  const TwoOnGround clamped(box, box, Vec3(0.125, 0.0625, 0.75), law);
  EXPECT_TRUE(clamped.answer().penetration_exceeded);
  EXPECT_FALSE(clamped.contact.tangents(clamped.state).complete);
  law.max_penetration = 0.5;
  const TwoOnGround within(box, box, Vec3(0.125, 0.0625, 0.75), law);
  EXPECT_FALSE(within.answer().penetration_exceeded);
  EXPECT_TRUE(within.contact.tangents(within.state).complete);
}

TEST(ContactForces, RefuseWhatIsNotThere) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  ContactForces contact(forces, matter);
  const Index plate = contact.add_surface(matter.Ground(), Transform(), fast::Surface(generate::plate(1, 1, 0.1)));
  EXPECT_THROW(contact.add_pairing(plate, plate), BadInput);
  EXPECT_THROW(contact.add_pairing(plate, 7), BadInput);
  const Index other = contact.add_surface(matter.Ground(), Transform(), fast::Surface(generate::plate(1, 1, 0.1)));
  ContactLaw law;
  law.stiffness = -1;
  EXPECT_THROW(contact.add_pairing(plate, other, law), BadInput);
  EXPECT_THROW(contact.pairing(0), BadInput);
  SimTK::MultibodySystem foreign_system;
  SimTK::SimbodyMatterSubsystem foreign(foreign_system);
  EXPECT_THROW(contact.add_surface(foreign.Ground(), Transform(), fast::Surface(generate::plate(1, 1, 0.1))), BadInput);
  EXPECT_EQ(contact.surfaces(), 2);
}

TEST(ContactForces, RefuseSurfacesPairingsAndTangentsThatAreNone) {
  const TwoBubblesOnPlate model;
  for (const Index none : {-1, 3}) {
    EXPECT_THROW(model.contact.surface_pose(model.state, none), BadInput) << none;
    EXPECT_THROW(model.contact.relative_pose(model.state, none), BadInput) << none;
    EXPECT_THROW(model.contact.relative_velocity(model.state, none), BadInput) << none;
    EXPECT_THROW(model.contact.contact(model.state, none), BadInput) << none;
  }
  SimTK::State state = model.state;
  EXPECT_THROW(model.contact.linearise(state, std::make_shared<ContactTangents>()), BadInput);
}

// A State knows nothing of what is added after it was made: Simbody refuses it, and the next one has all forces.
TEST(ContactForces, OfWhatIsAddedLaterWantANewState) {
  TwoBubblesOnPlate model;
  model.body_forces(model.state);
  const Index added = model.contact.add_pairing(1, 2, rough(), Mode::E);
  EXPECT_FALSE(model.system.systemTopologyHasBeenRealized());
  const SimTK::Vector q = model.state.getQ(), u = model.state.getU();
  model.state = model.system.realizeTopology();
  model.state.updQ() = q;
  model.state.updU() = u;
  model.system.realize(model.state, SimTK::Stage::Velocity);
  EXPECT_EQ(model.contact.answers(model.state).size(), 4U);
  EXPECT_TRUE(model.contact.answers(model.state)[static_cast<std::size_t>(added)].touching);
  model.contact.add_surface(model.lower, Transform(), fast::Surface(generate::plate(1, 1, 0.1)));
  EXPECT_FALSE(model.system.systemTopologyHasBeenRealized());
}

}  // namespace
}  // namespace pcm::simbody
