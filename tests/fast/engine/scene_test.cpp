// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcm/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/hard_bodies.h"
#include "meshes/generate/parts.h"
#include "tests/fast/engine_support.h"
#include "tests/fast/same_answer.h"
#include "tests/meshes/expect_bad_input.h"

namespace pcm::fast {
namespace {

using Eigen::Vector3d;

/// Bubbles, a ball and an open pyramid that wander into, through and past each other.
struct Wandering {
  Scene scene;
  double time = 0;

  explicit Wandering(Savings savings) : scene(savings) {
    const Surface bubble(generate::bubble());
    const Surface ball(generate::icosphere(0.25, 2));
    const Surface pyramid(generate::pyramid(0.5, 0.15));
    for (int b = 0; b < 8; ++b) scene.add_body(b % 4 == 3 ? pyramid : b % 2 == 0 ? bubble : ball);
    for (Index E = 0; E < scene.bodies(); ++E) {
      for (Index F = E + 1; F < scene.bodies(); ++F) {
        Wanted wanted;
        wanted.bound = (E + F) % 5 == 0;
        wanted.elements = (E + F) % 2 == 0;
        scene.add_pairing(E, F, test::rough(1000), (E + F) % 3 == 0 ? Mode::both : Mode::E,
                          F % 4 == 1 ? Scheme::clipped : Scheme::barycentric, wanted);
      }
    }
  }

  std::vector<BodyState> states() const {
    std::vector<BodyState> states(8);
    for (int b = 0; b < 8; ++b) {
      const double phase = 0.7 * b, t = time;
      BodyState& state = states[static_cast<std::size_t>(b)];
      state.pose = test::turned(phase + t, {0.35 * std::cos(phase + t), 0.35 * std::sin(2 * phase - 0.7 * t),
                                            0.2 * std::sin(phase + 1.3 * t)});
      state.velocity = {{0.1 * b, -0.2, 0.3}, {0.4, 0.1 * b, -0.2}};
    }
    return states;
  }
  void step(double dt) {
    time += dt;
    scene.move(states());
  }
};

TEST(Scene, WithAndWithoutSavingsAnswersEveryPairingBitForBitAlike) {
  Wandering saving({}), plain(Savings::none());
  Workspace one, other;
  SceneCounters total;
  int touching = 0;
  for (int step = 0; step < 60; ++step) {
    saving.step(step % 10 == 0 ? 0.5 : 0.002);
    plain.time = saving.time;
    plain.scene.move(plain.states());
    for (Index i = 0; i < saving.scene.pairings(); ++i) {
      SCOPED_TRACE("step " + std::to_string(step) + ", pairing " + std::to_string(i));
      const Contact& a = saving.scene.evaluate(i, one);
      const Contact& b = plain.scene.evaluate(i, other);
      test::expect_same_answer(a, b);
      touching += a.touching;
    }
    const SceneCounters counters = saving.scene.counters();
    EXPECT_EQ(counters.apart_by_boxes + counters.apart_by_certificate + counters.evaluated, saving.scene.pairings());
    total.apart_by_boxes += counters.apart_by_boxes;
    total.apart_by_certificate += counters.apart_by_certificate;
    EXPECT_EQ(plain.scene.counters().evaluated, plain.scene.pairings());
    EXPECT_EQ(plain.scene.counters().certificates_sought, 0);
  }
  // Everything has happened.
  EXPECT_GT(total.apart_by_boxes, 100);
  EXPECT_GT(total.apart_by_certificate, 50);
  EXPECT_GT(touching, 100);
}

/// As in difference quotients: one body after the other is faster, every fourth one is elsewhere too, and then all are
/// back. Before poses are remembered anew everything is asked once without.
TEST(Scene, AtRememberedPosesOnlyTheLawIsAppliedToTheSameBits) {
  Wandering remembering({}), plain(Savings::none());
  Workspace one, other;
  std::int64_t law_only = 0, evaluated_again = 0;
  for (int step = 0; step < 12; ++step) {
    remembering.time = 0.3 * step;
    for (int column = -2; column <= 8; ++column) {
      std::vector<BodyState> states = remembering.states();
      const bool changed = column >= 0 && column < 8;
      if (changed) states[static_cast<std::size_t>(column)].velocity.v += Vector3d(1e-3, -0.1, 0.2);
      if (changed && column % 4 == 3) states[static_cast<std::size_t>(column)].pose.r.y() += 1e-7;
      remembering.scene.move(states);
      plain.scene.move(states);
      if (column == -1) remembering.scene.remember_poses();
      for (Index i = 0; i < plain.scene.pairings(); ++i) {
        SCOPED_TRACE("step " + std::to_string(step) + ", column " + std::to_string(column) + ", pairing " +
                     std::to_string(i));
        test::expect_same_answer(remembering.scene.evaluate(i, one), plain.scene.evaluate(i, other));
        if (HasFailure()) return;
      }
      const SceneCounters counters = remembering.scene.counters();
      if (column < 0) {
        EXPECT_EQ(counters.work.law_only, 0);
      }
      law_only += counters.work.law_only;
      if (column >= 0) evaluated_again += counters.evaluated - counters.work.law_only;
    }
  }
  // Found anew are pairings with a bound, a fifth of them, and seven of 28 in a fifth of the columns.
  EXPECT_GT(law_only, 500);
  EXPECT_LT(evaluated_again, law_only);
}

TEST(Scene, AnyNumberOfThreadsGivesTheSameBits) {
  Wandering one({});
  for (const int threads : {2, 3, 8}) {
    Wandering many({});
    one.time = 0;
    for (int step = 0; step < 20; ++step) {
      one.step(0.03);
      many.step(0.03);
      std::vector<Contact> seen(static_cast<std::size_t>(one.scene.pairings()));
      std::vector<Contact> seen_by_many = seen;
      one.scene.evaluate_all(1, [&](Index i, const Contact& contact) { seen[static_cast<std::size_t>(i)] = contact; });
      many.scene.evaluate_all(
          threads, [&](Index i, const Contact& contact) { seen_by_many[static_cast<std::size_t>(i)] = contact; });
      for (std::size_t i = 0; i < seen.size(); ++i) test::expect_same_answer(seen[i], seen_by_many[i]);
      const std::vector<BodyLoad> loads = one.scene.body_loads(), loads_of_many = many.scene.body_loads();
      for (std::size_t b = 0; b < loads.size(); ++b) {
        EXPECT_TRUE(test::same(loads[b].force_W, loads_of_many[b].force_W));
        EXPECT_TRUE(test::same(loads[b].torque_W, loads_of_many[b].torque_W));
      }
    }
  }
}

TEST(Scene, LoadsOfAllBodiesBalance) {
  Wandering wandering({});
  wandering.step(0.1);
  wandering.scene.evaluate_all();
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();
  double scale = 0;
  const std::vector<BodyLoad> loads = wandering.scene.body_loads();
  for (std::size_t b = 0; b < loads.size(); ++b) {
    force += loads[b].force_W;
    torque += loads[b].torque_W + wandering.states()[b].pose.r.cross(loads[b].force_W);
    scale += loads[b].force_W.norm() + loads[b].torque_W.norm();
  }
  ASSERT_GT(scale, 1);
  EXPECT_LT(force.norm(), 1e-13 * scale);
  EXPECT_LT(torque.norm(), 1e-13 * scale);
}

TEST(Scene, LoadsOfBodiesAreThoseOfTheLastEvaluationWhereverBodiesHaveGoneSince) {
  Wandering wandering({});
  wandering.step(0.1);
  wandering.scene.evaluate_all();
  const std::vector<BodyLoad> loads = wandering.scene.body_loads();
  wandering.step(0.3);
  const std::vector<BodyLoad> later = wandering.scene.body_loads();
  double scale = 0;
  for (std::size_t b = 0; b < loads.size(); ++b) {
    EXPECT_TRUE(test::same(loads[b].force_W, later[b].force_W));
    EXPECT_TRUE(test::same(loads[b].torque_W, later[b].torque_W));
    scale += loads[b].force_W.norm();
  }
  EXPECT_GT(scale, 1);
}

TEST(Scene, CountsWhatBecameOfThePairingsWhenTheyWereLastAskedFor) {
  Scene scene;
  for (int b = 0; b < 2; ++b) scene.add_body(Surface(generate::icosphere(1, 2)));
  scene.add_pairing(0, 1);
  // Their boxes touch, they do not.
  BodyState E, F;
  F.pose.r = {1.5, 1.5, 0.1};
  scene.move({E, F});
  scene.evaluate_all();
  const SceneCounters first = scene.counters();
  EXPECT_EQ(first.evaluated, 1);
  EXPECT_EQ(first.certificates_sought, 1);
  EXPECT_GT(first.work.box_tests, 0);
  scene.evaluate_all();
  const SceneCounters second = scene.counters();
  EXPECT_EQ(second.evaluated, 0);
  EXPECT_EQ(second.apart_by_certificate, 1);
  EXPECT_EQ(second.certificates_sought, 0);
  EXPECT_EQ(second.work.box_tests, 0);
  scene.move({E, F});
  const SceneCounters not_asked = scene.counters();
  EXPECT_EQ(not_asked.evaluated + not_asked.apart_by_boxes + not_asked.apart_by_certificate, 0);
  EXPECT_EQ(not_asked.certificates_sought, 0);
}

TEST(Scene, FarFromTheOriginBoxesOfTouchingBodiesStillTouch) {
  // Relative poses are off by an ulp of the bodies' coordinates, here 1e-4 m.
  const Surface box(generate::box({1, 1, 1}));
  Workspace workspace;
  int touching = 0;
  for (int k = -20; k <= 20; ++k) {
    Scene scene, plain(Savings::none());
    for (Scene* s : {&scene, &plain}) {
      s->add_body(box);
      s->add_body(box);
      s->add_pairing(0, 1);
      BodyState E, F;
      E.pose.r = {0x1p40, 0x1p40, 0x1p40};
      E.pose.A = test::turned(0.3, Eigen::Vector3d::Zero()).A;
      F.pose.A = E.pose.A;
      F.pose.r = E.pose.r + E.pose.A.col(0) + Vector3d::Constant(k * 0x1p-13);
      s->move({E, F});
    }
    const bool a = scene.evaluate(0, workspace).touching, b = plain.evaluate(0, workspace).touching;
    EXPECT_EQ(a, b);
    touching += a;
  }
  EXPECT_GT(touching, 5);
  EXPECT_LT(touching, 36);
}

TEST(Scene, BodiesThatTouchByLessThanTheirBoxesAreRoundedByAreNotApart) {
  // Each box is 0.8 ulp of 2^20 longer than 1, a part that is lost where its middle and its half are rounded there; the
  // bodies overlap by 0.6 ulp, and their boxes as computed are an ulp apart.
  constexpr double kUlp = 0x1p-32;
  TriangleMesh longer_ahead = generate::box({1, 1, 1}), longer_behind = longer_ahead;
  for (Vector3d& x : longer_ahead.vertices) x.x() += x.x() > 0 ? 0.8 * kUlp : 0;
  for (Vector3d& x : longer_behind.vertices) x.x() -= x.x() < 0 ? 0.8 * kUlp : 0;
  Scene scene;
  scene.add_body(Surface(longer_ahead));
  scene.add_body(Surface(longer_behind));
  scene.add_pairing(0, 1);
  BodyState E, F;
  E.pose.r = {0x1p20, 0, 0};
  F.pose.r = {0x1p20 + 1 + kUlp, 0.25, 0.125};
  scene.move({E, F});
  Workspace workspace;
  EXPECT_TRUE(scene.evaluate(0, workspace).touching);
}

TEST(Scene, ABodyInTheCavityOfAnotherIsApartByCertificate) {
  Scene scene;
  TriangleMesh hollow = generate::box({4, 4, 4});
  TriangleMesh cavity = generate::box({3, 3, 3});
  const auto offset = static_cast<Index>(hollow.vertices.size());
  hollow.vertices.insert(hollow.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
  for (const Triangle& t : cavity.faces) hollow.faces.push_back({t[0] + offset, t[2] + offset, t[1] + offset});
  scene.add_body(Surface(hollow));
  scene.add_body(Surface(generate::bubble()));
  scene.add_pairing(0, 1);
  BodyState state;
  for (int step = 0; step < 100; ++step) {
    state.pose = test::turned(0.01 * step, {0.01 * step, 0, 0});
    scene.move({BodyState{}, state});
    scene.evaluate_all();
    EXPECT_FALSE(scene.load(0).touching);
    EXPECT_EQ(scene.counters().evaluated + scene.counters().apart_by_certificate, 1);
    if (step == 1) {
      EXPECT_EQ(scene.counters().apart_by_certificate, 1);
    }
  }
  // The same in the solid: nested, never skipped.
  Scene solid;
  solid.add_body(Surface(generate::box({4, 4, 4})));
  solid.add_body(Surface(generate::bubble()));
  solid.add_pairing(0, 1);
  for (int step = 0; step < 3; ++step) {
    solid.evaluate_all();
    EXPECT_TRUE(solid.load(0).nested);
    EXPECT_EQ(solid.counters().evaluated, 1);
  }
}

/// A small box in the loop of a figure of eight that is wound about -1 times: neither touches nor is nested, and has an
/// area and a volume all the same. No step before may make the scene forget it.
TEST(Scene, ABodyInAFoldOfNegativeWindingKeepsItsAreaWhateverCameBefore) {
  const Surface eight(degenerate::figure_of_eight());
  const Surface small(generate::box({-0.155, -0.01, -0.1}, {-0.145, 0.01, 0.1}));
  Workspace workspace;
  const Contact alone = evaluate(Pairing(small, eight), {}, {}, {}, workspace);
  ASSERT_FALSE(alone.touching || alone.nested);
  ASSERT_LT(alone.volume, 0);
  Scene scene;
  scene.add_body(small);
  scene.add_body(eight);
  scene.add_pairing(0, 1);
  std::vector<BodyState> states(2);
  for (const double x : {1e-4, 5e-5, 0.0}) {
    states[0].pose.r[0] = x;
    scene.move(states);
    scene.evaluate(0, workspace);
  }
  const Contact& in_scene = scene.evaluate(0, workspace);
  EXPECT_EQ(in_scene.volume, alone.volume);
  EXPECT_EQ(in_scene.E.area, alone.E.area);
}

TEST(Scene, RefusesWhatItCanNotPlaceAndStaysAsItWas) {
  Scene scene;
  scene.add_body(Surface(generate::box({1, 1, 1})));
  scene.add_body(Surface(generate::box({1, 1, 1})));
  expect_bad_input([&] { scene.add_pairing(0, 2); }, "no body 2");
  expect_bad_input([&] { scene.add_pairing(1, 1); }, "body 1 with itself");
  expect_bad_input([&] { scene.load(0); }, "no pairing 0, it has 0");
  scene.add_pairing(0, 1);
  BodyState E, F;
  F.pose.r = {0.5, 0.25, 0.125};
  scene.move({E, F});
  expect_bad_input([&] { scene.move({E}); }, "1 states for 2 bodies");
  BodyState skew = F;
  skew.pose.A(0, 1) = 5e-10;
  BodyState elsewhere = E;
  elsewhere.pose.r = {7, 0, 0};
  expect_bad_input([&] { scene.move({elsewhere, skew}); }, "body 1: pose: A is no rotation to 1e-10");
  for (Eigen::Vector3d Velocity::*velocity : {&Velocity::v, &Velocity::w}) {
    BodyState fast = F;
    (fast.velocity.*velocity).z() = 0x1p301;
    expect_bad_input([&] { scene.move({elsewhere, fast}); }, "body 1: velocity: a component exceeds 2^300");
  }
  BodyState nowhere = F;
  nowhere.pose.r.z() = std::numeric_limits<double>::infinity();
  expect_bad_input([&] { scene.move({nowhere, F}); }, "body 0: ");
  scene.evaluate_all(2);
  EXPECT_TRUE(scene.load(0).touching);
  EXPECT_EQ(scene.relative_pose(0).r, F.pose.r);
}

TEST(Scene, WhatFailsInAThreadIsThrownToTheCallerAndTheSceneStaysUsable) {
  Scene scene;
  scene.add_body(Surface(generate::box({1, 1, 1})));
  scene.add_body(Surface(generate::box({1, 1, 1})));
  ContactLaw huge = test::stiffness(1e308);
  huge.damping = 1e308;
  huge.damping_mode = DampingMode::full;
  scene.add_pairing(0, 1, huge);
  scene.add_pairing(0, 1, test::stiffness(1));
  BodyState E, F;
  F.pose.r = {0.25, 0.25, 0.125};
  F.velocity.v = {1e9, 2e9, 3e9};
  scene.move({E, F});
  expect_bad_input([&] { scene.evaluate_all(0); }, "at least 1 thread");
  expect_bad_input([&] { scene.evaluate_all(2); }, "exceeds the range of doubles");
  EXPECT_FALSE(scene.load(0).touching);
  EXPECT_TRUE(scene.load(1).touching);
}

TEST(Scene, OfSeveralThatFailTheFirstOnesFailureIsThrown) {
  Scene scene;
  for (int b = 0; b < 12; ++b) scene.add_body(Surface(generate::box({1, 1, 1})));
  for (Index b = 0; b + 1 < scene.bodies(); ++b) scene.add_pairing(b, b + 1);
  std::vector<BodyState> states(12);
  for (std::size_t b = 0; b < states.size(); ++b) states[b].pose.r = {0.75 * static_cast<double>(b), 0.25, 0.125};
  scene.move(states);
  for (const int threads : {1, 2, 3})
    for (const Index first : {0, 4, 9}) {
      const auto fail = [&](Index pairing, const Contact&) {
        if (pairing >= first) throw std::runtime_error("pairing " + std::to_string(pairing));
      };
      try {
        scene.evaluate_all(threads, fail);
        ADD_FAILURE() << threads << " threads, first " << first;
      } catch (const std::runtime_error& error) {
        EXPECT_EQ(error.what(), "pairing " + std::to_string(first)) << threads << " threads";
      }
    }
}

}  // namespace
}  // namespace pcm::fast
