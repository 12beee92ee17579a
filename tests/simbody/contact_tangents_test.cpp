// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Forces by tangents of the pairings, at States that hold them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "tests/simbody/two_bubbles_on_plate.h"

namespace pcm::simbody {
namespace {

/// The same model at its state, with the tangents that it has there.
struct Linearised {
  TwoBubblesOnPlate model{Scheme::clipped};
  std::shared_ptr<const ContactTangents> tangents;

  Linearised() {
    // Slow enough that friction is regularised, and no element's damping exceeds its spring.
    model.state.updU() *= 5e-3;
    model.system.realize(model.state, SimTK::Stage::Velocity);
    tangents = std::make_shared<ContactTangents>(model.contact.tangents(model.state));
  }

  /// Another State, moved from the model's along all coordinates and speeds.
  SimTK::State moved(double distance, double speed) const {
    SimTK::State state = model.state;
    for (int i = 0; i < state.getNQ(); ++i) state.updQ()[i] += distance * std::sin(1.0 + 3 * i);
    for (int i = 0; i < state.getNU(); ++i) state.updU()[i] += speed * std::cos(2.0 + 5 * i);
    return state;
  }
  SimTK::Vector_<SpatialVec> forces_at(SimTK::State state, bool by_tangents) const {
    if (by_tangents) model.contact.linearise(state, tangents);
    model.system.realize(state, SimTK::Stage::Velocity);
    return model.body_forces(state);
  }
};

double norm(const SimTK::Vector_<SpatialVec>& forces) {
  double sum = 0;
  for (int i = 0; i < forces.size(); ++i) sum += forces[i][0].normSqr() + forces[i][1].normSqr();
  return std::sqrt(sum);
}

TEST(ContactTangents, CostAnEvaluationOfEachPairing) {
  const Linearised linear;
  EXPECT_TRUE(linear.tangents->complete);
  EXPECT_TRUE(linear.tangents->any());
  const ContactCounters counters = linear.model.contact.counters();
  EXPECT_EQ(counters.states, 1);
  EXPECT_EQ(counters.evaluated, 3 + 3);  // three pairings, at the state and for its tangents
  EXPECT_EQ(counters.law_only, 0);
}

TEST(ContactTangents, AreTheForcesWhereTheyWereTakenAndAskNoEngine) {
  const Linearised linear;
  const SimTK::Vector_<SpatialVec> forces = linear.forces_at(linear.model.state, false);
  const std::int64_t evaluated = linear.model.contact.counters().evaluated;
  EXPECT_LT(norm(linear.forces_at(linear.model.state, true) - forces), 1e-14 * norm(forces));
  (void)linear.forces_at(linear.moved(1e-5, 1e-5), true);
  EXPECT_EQ(linear.model.contact.counters().evaluated, evaluated);
}

// Both bodies of a pairing move, E's too: what the tangents lack is of second order, and a fourth at half the way.
TEST(ContactTangents, AreTheEnginesForcesToSecondOrder) {
  const Linearised linear;
  const SimTK::Vector_<SpatialVec> here = linear.forces_at(linear.model.state, false);
  for (const bool speeds : {false, true}) {
    SCOPED_TRACE(speeds);
    const auto changes = [&](double size) {
      const SimTK::State state = linear.moved(speeds ? 0 : size, speeds ? size : 0);
      const SimTK::Vector_<SpatialVec> engines = linear.forces_at(state, false);
      return std::make_pair(norm(engines - here), norm(linear.forces_at(state, true) - engines));
    };
    const auto [change, lack] = changes(4e-5);
    const auto [half_change, half_lack] = changes(2e-5);
    EXPECT_NEAR(change / half_change, 2, 0.1);
    EXPECT_LT(lack, 0.05 * change);
    EXPECT_NEAR(lack / half_lack, 4, 0.8);
  }
}

// Two free bodies, turned and moved as one: the forces on them turn along.
TEST(ContactTangents, TurnWithTheBodies) {
  const Linearised linear;
  ContactTangents of_bubbles = *linear.tangents;
  of_bubbles.pairings[0].reset();
  of_bubbles.pairings[2].reset();
  const auto tangents = std::make_shared<const ContactTangents>(of_bubbles);
  const TwoBubblesOnPlate& model = linear.model;
  SimTK::State turned = model.state;
  const Transform X(SimTK::Rotation(1.1, SimTK::UnitVec3(2, -1, 3)), Vec3(0.3, -2, 1));
  const Vec3 w(0.3, -0.5, 0.2), v(1, 2, -1);
  for (const SimTK::MobilizedBody::Free& body : {model.lower, model.upper}) {
    const Transform X_GB = X * body.getBodyTransform(model.state);
    const SpatialVec V = X.R() * body.getBodyVelocity(model.state);
    body.setQToFitTransform(turned, body.getInboardFrame(turned).invert() * X_GB);
    model.system.realize(turned, SimTK::Stage::Position);
    const SimTK::Rotation R_FG = ~body.getInboardFrame(turned).R();
    body.setUToFitVelocity(turned, R_FG * SpatialVec(V[0] + w, V[1] + v + w % X_GB.p()));
  }
  SimTK::State here = model.state;
  for (SimTK::State* state : {&here, &turned}) {
    model.contact.linearise(*state, tangents);
    model.system.realize(*state, SimTK::Stage::Velocity);
  }
  const SimTK::Vector_<SpatialVec> before = model.body_forces(here), after = model.body_forces(turned);
  for (const SimTK::MobilizedBody::Free& body : {model.lower, model.upper}) {
    const SpatialVec expected = X.R() * before[body.getMobilizedBodyIndex()];
    ASSERT_GT(expected[1].norm(), 10);
    for (int k = 0; k < 2; ++k)
      EXPECT_LT((after[body.getMobilizedBodyIndex()][k] - expected[k]).norm(), 1e-11 * expected[1].norm());
  }
}

TEST(ContactTangents, OfWhatDoesNotTouchAreNone) {
  TwoBubblesOnPlate model;
  model.state.updQ()[13] += 1;  // the upper bubble is far above
  model.system.realize(model.state, SimTK::Stage::Velocity);
  const auto tangents = std::make_shared<ContactTangents>(model.contact.tangents(model.state));
  EXPECT_TRUE(tangents->pairings[0].has_value());
  EXPECT_FALSE(tangents->pairings[1].has_value());
  EXPECT_FALSE(tangents->pairings[2].has_value());
  SimTK::State lowered = model.state;
  lowered.updQ()[13] -= 1;
  model.contact.linearise(lowered, tangents);
  model.system.realize(lowered, SimTK::Stage::Velocity);
  EXPECT_EQ(model.body_forces(lowered)[model.upper.getMobilizedBodyIndex()][1].norm(), 0);
}

TEST(ContactTangents, AreForgottenByAStateThatIsGivenNone) {
  const Linearised linear;
  SimTK::State state = linear.moved(1e-4, 1e-4);
  linear.model.contact.linearise(state, linear.tangents);
  linear.model.contact.linearise(state, nullptr);
  linear.model.system.realize(state, SimTK::Stage::Velocity);
  EXPECT_EQ(norm(linear.model.body_forces(state) - linear.forces_at(linear.moved(1e-4, 1e-4), false)), 0);
}

}  // namespace
}  // namespace pcm::simbody
