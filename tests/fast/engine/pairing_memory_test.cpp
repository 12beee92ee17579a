// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcm/pairing_memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "tests/fast/engine_support.h"
#include "tests/fast/same_answer.h"
#include "tests/meshes/expect_bad_input.h"

namespace pcm::fast {
namespace {

constexpr Wanted kForce{false, false, true, false, false, false};

const ContactLaw kRough = test::rough(1e5);

/// Elastic, and with everything that a law has, in turn.
std::vector<ContactLaw> laws() {
  std::vector<ContactLaw> laws{test::stiffness(1), kRough, kRough, kRough, kRough};
  laws[2].damping_mode = DampingMode::full;
  laws[2].slip_velocity = 0;
  laws[3].damping_mode = DampingMode::compression;
  laws[3].layers = LayerStiffness{1e6, 3e6};
  laws[4].max_penetration = 0.02;
  return laws;
}

std::vector<Wanted> questions() {
  Wanted everything;
  return {everything,
          kForce,
          {false, false, false, false, false, true},    // statistics
          {false, true, false, true, false, false},     // areas and elements
          {true, false, false, false, false, false},    // polygons
          {false, false, false, false, false, false}};  // touch
}

/// Towards each other, apart, askew, at rest.
std::vector<Velocity> velocities() {
  return {{{0.1, -0.2, 0.3}, {0.4, 0.1, -0.2}}, {{-1, 0, -2}, {0, 0, 5}}, {{0.001, 0.002, 0}, {0, 0, 0}}, Velocity{}};
}

struct Bodies {
  Surface E, F;
  Pose pose;
};

/// In one touch of two bodies more elements are than lanes, in another fewer; an open surface; none touch; nested.
std::vector<Bodies> bodies() {
  const Surface bubble(generate::bubble()), box(generate::box({1, 1, 1})), ball(generate::icosphere(0.25, 2));
  return {{bubble, bubble, test::turned(0.3, {0.05, 0.1, 0.12})},
          {box, ball, test::turned(1, {0.5, 0.1, 0.6})},
          {Surface(generate::pyramid(0.5, 0.15)), bubble, test::turned(0.3, {0.01, 0.02, 0.05})},
          {bubble, bubble, test::turned(0.3, {0.3, 0.1, 0.3})},
          {Surface(generate::box({8, 8, 8})), ball, test::turned(0.1, {0.1, 0, 0})}};
}

class InBothSchemes : public testing::TestWithParam<Scheme> {};

TEST_P(InBothSchemes, AnotherVelocityHasTheBitsOfAWholeEvaluation) {
  Workspace one, other;
  std::int64_t elements = 0, by_law = 0;
  for (const Bodies& touch : bodies()) {
    for (const ContactLaw& law : laws()) {
      for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
        const Pairing pairing(touch.E, touch.F, law, mode, GetParam());
        PairingMemory memory(pairing);
        for (const Wanted& wanted : questions()) {
          bool first = true;
          for (const Velocity& velocity : velocities()) {
            const Contact& answer = memory.evaluate(touch.pose, velocity, wanted, one);
            const Contact& whole = evaluate(pairing, touch.pose, velocity, wanted, other);
            test::expect_same_answer(answer, whole);
            EXPECT_EQ(answer.work.law_only, first ? 0 : 1);
            EXPECT_EQ(answer.work.elements, whole.work.elements);
            EXPECT_EQ(answer.work.velocities, whole.work.velocities);
            if (!first) {
              EXPECT_EQ(answer.work.box_tests + answer.work.vertices_transformed + answer.work.predicates, 0);
              elements += answer.work.elements;
            }
            by_law += answer.work.law_only;
            first = false;
            if (HasFailure()) return;
          }
        }
      }
    }
  }
  EXPECT_GT(elements, 1000);
  EXPECT_EQ(by_law, 5 * 5 * 3 * 6 * 3);
}

TEST_P(InBothSchemes, WhatComesInBetweenIsNeverTakenForTheAnswer) {
  const Bodies touch = bodies().front();
  const Pairing pairing(touch.E, touch.F, kRough, Mode::both, GetParam());
  PairingMemory memory(pairing);
  Workspace one, other;
  const auto ask = [&](const Pose& pose, const Velocity& velocity, const Wanted& wanted, const Savings& savings,
                       bool by_law) {
    const Contact& answer = memory.evaluate(pose, velocity, wanted, one, savings);
    EXPECT_EQ(answer.work.law_only, by_law ? 1 : 0);
    test::expect_same_answer(answer, evaluate(pairing, pose, velocity, wanted, other));
  };
  const Velocity v = velocities()[0], w = velocities()[1];
  Pose nearby = touch.pose;
  nearby.r.x() = std::nextafter(nearby.r.x(), 1);
  Wanted bounded;
  bounded.bound = true;
  Savings off, all_wanted;
  off.known_poses = false;
  all_wanted.only_wanted = false;
  ask(touch.pose, v, {}, {}, false);
  // Another pose by an ulp, and back.
  ask(nearby, v, {}, {}, false);
  ask(nearby, w, {}, {}, true);
  ask(touch.pose, w, {}, {}, false);
  // Another question.
  ask(touch.pose, v, kForce, {}, false);
  ask(touch.pose, w, kForce, {}, true);
  // Others use the workspace; what must be found anew leaves what is known.
  evaluate(Pairing(touch.F, touch.E, laws()[0], Mode::F), nearby, w, {}, one);
  ask(touch.pose, v, bounded, {}, false);
  ask(touch.pose, v, kForce, off, false);
  ask(touch.pose, v, kForce, all_wanted, false);
  ask(touch.pose, v, kForce, {}, true);
  one = Workspace();
  ask(touch.pose, w, kForce, {}, true);
  // It moves house.
  PairingMemory moved = std::move(memory);
  memory = std::move(moved);
  ask(touch.pose, v, kForce, {}, true);
}

TEST_P(InBothSchemes, OneWishMoreAtTheSamePoseIsAnotherQuestion) {
  const Bodies touch = bodies().front();
  const Pairing pairing(touch.E, touch.F, kRough, Mode::both, GetParam());
  Workspace one, other;
  for (bool Wanted::*const wish :
       {&Wanted::polygons, &Wanted::areas, &Wanted::elements, &Wanted::statistics, &Wanted::tangent, &Wanted::force}) {
    Wanted wanted = kForce;
    wanted.*wish = false;
    PairingMemory memory(pairing);
    memory.evaluate(touch.pose, velocities()[0], wanted, one);
    wanted.*wish = true;
    const Contact& answer = memory.evaluate(touch.pose, velocities()[1], wanted, one);
    EXPECT_EQ(answer.work.law_only, 0);
    test::expect_same_answer(answer, evaluate(pairing, touch.pose, velocities()[1], wanted, other));
  }
}

TEST_P(InBothSchemes, AZeroOfTheOtherSignIsAnotherPose) {
  const Surface bubble(generate::bubble());
  const Pairing pairing(bubble, bubble, kRough, Mode::E, GetParam());
  PairingMemory memory(pairing);
  Workspace one, other;
  Pose pose;
  pose.r = {0, 0, 0.3};
  memory.evaluate(pose, velocities()[0], {}, one);
  pose.r.x() = -0.0;
  const Contact& answer = memory.evaluate(pose, velocities()[0], {}, one);
  EXPECT_EQ(answer.work.law_only, 0);
  test::expect_same_answer(answer, evaluate(pairing, pose, velocities()[0], {}, other));
}

TEST_P(InBothSchemes, BadVelocitiesAreRefusedAndNothingIsForgotten) {
  const Bodies touch = bodies().front();
  ContactLaw law = kRough;
  law.damping_mode = DampingMode::full;
  law.damping = 1e120;
  const Pairing pairing(touch.E, touch.F, law, Mode::E, GetParam());
  PairingMemory memory(pairing);
  Workspace workspace, other;
  const Velocity v = velocities()[0];
  Velocity infinite = v, huge = v, beyond = v;
  infinite.w.y() = std::numeric_limits<double>::infinity();
  huge.v = {1e200, 1e200, 1e200};
  beyond.w.x() = -0x1.1p700;
  const auto ask = [&](const Velocity& velocity) -> const Contact& {
    return memory.evaluate(touch.pose, velocity, {}, workspace);
  };
  // At a pose that is not known yet.
  expect_bad_input([&] { ask(infinite); }, "velocity: v and w must be finite");
  expect_bad_input([&] { ask(beyond); }, "velocity: greatest |v| or |w|");
  expect_bad_input([&] { ask(huge); }, "force or torque exceeds");
  EXPECT_EQ(ask(v).work.law_only, 0);
  // At one that is.
  expect_bad_input([&] { ask(infinite); }, "velocity: v and w must be finite");
  expect_bad_input([&] { ask(beyond); }, "velocity: greatest |v| or |w|");
  expect_bad_input([&] { ask(huge); }, "force or torque exceeds");
  EXPECT_EQ(ask(v).work.law_only, 1);
  test::expect_same_answer(ask(v), evaluate(pairing, touch.pose, v, {}, other));
}

INSTANTIATE_TEST_SUITE_P(PairingMemory, InBothSchemes, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const testing::TestParamInfo<Scheme>& scheme) {
                           return scheme.param == Scheme::clipped ? "Clipped" : "Barycentric";
                         });

}  // namespace
}  // namespace pcm::fast
