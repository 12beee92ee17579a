// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "pcm/bad_input.h"
#include "pcm/pairing_memory.h"
#include "pcm/scene.h"
#include "tests/fast/engine_support.h"
#include "tests/fast/same_answer.h"

/// Derivatives of force and torque. Against exact ones of any contact they are held by `pcm verify` and by
/// tests/compare/verify/verdict/tangent_verdict_test.cpp; here are those that are known by hand.
namespace pcm::fast {
namespace {

using test::kTangent;

/// A cube of edge 1/2, its bottom at z = 0, and a wide plate with its top at z = 0, raised by 1/16.
constexpr double kRaised = 0.0625, kBottom = 0.25;
TriangleMesh cube() {
  return generate::box({-0.25, -0.25, 0}, {0.25, 0.25, 0.5});
}
TriangleMesh raised_plate() {
  return generate::box({-2, -2, -1}, {2, 2, 0});
}
Tangent of_cube_on_plate(const ContactLaw& law, const Velocity& velocity = {}) {
  return *test::answer(cube(), raised_plate(), shifted(0, 0, kRaised), law, Mode::E, velocity, kTangent).tangent;
}

TEST(Tangent, OfACubeOnAPlateIsStiffnessTimesArea) {
  const Tangent tangent = of_cube_on_plate(test::stiffness(100));
  const double N = 100 * kBottom * kRaised;
  Tangent expected = Tangent::Zero();
  expected(2, 2) = 100 * kBottom;
  // The arm from Mf loses dr.
  expected(3, 1) = -N;
  expected(4, 0) = N;
  // The bottom's two triangles: barycentres at -+(1/12, 1/12), or at -+(1/12, -1/12), areas 1/8.
  const double tilt = 2 * 100 * (kBottom / 2) / 144;
  expected(3, 3) = expected(4, 4) = tilt;
  expected(3, 4) = expected(4, 3) = std::copysign(tilt, tangent(3, 4));
  EXPECT_LT((tangent - expected).lpNorm<Eigen::Infinity>(), 1e-14);
}

TEST(Tangent, AtAKinkOfTheLawIsThatOfOneSide) {
  ContactLaw law = test::stiffness(100);
  law.max_penetration = kRaised;
  EXPECT_EQ(of_cube_on_plate(law)(2, 2), 0);
  law.max_penetration = std::nextafter(kRaised, 1);
  EXPECT_EQ(of_cube_on_plate(law)(2, 2), 100 * kBottom);

  law = test::stiffness(100);
  law.damping = 8;
  law.transition_depth = kRaised;
  EXPECT_EQ(of_cube_on_plate(law)(2, 8), 8 * kBottom);
  law.transition_depth = 2 * kRaised;
  EXPECT_EQ(of_cube_on_plate(law)(2, 8), 4 * kBottom);
  law.transition_depth = 0;
  law.damping_mode = DampingMode::compression;
  EXPECT_EQ(of_cube_on_plate(law)(2, 8), 8 * kBottom);
  EXPECT_EQ(of_cube_on_plate(law, {{0, 0, -1e-9}, {0, 0, 0}})(2, 8), 0);

  law.damping_mode = DampingMode::no_tension;
  const double no_force = -100 * kRaised / 8;
  EXPECT_EQ(of_cube_on_plate(law, {{0, 0, no_force}, {0, 0, 0}})(2, 8), 8 * kBottom);
  EXPECT_EQ(of_cube_on_plate(law, {{0, 0, std::nextafter(no_force, -9)}, {0, 0, 0}})(2, 8), 0);
  law.damping_mode = DampingMode::full;
  EXPECT_EQ(of_cube_on_plate(law, {{0, 0, 2 * no_force}, {0, 0, 0}})(2, 8), 8 * kBottom);
}

TEST(Tangent, OfFrictionIsSteepBelowTheSlipVelocityAndTurnsWithTheSlipAbove) {
  ContactLaw law = test::stiffness(100);
  law.friction = 0.5;
  const double most = 0.5 * 100 * kBottom * kRaised;
  EXPECT_EQ(of_cube_on_plate(law)(0, 6), 0);
  law.slip_velocity = 0.25;
  EXPECT_EQ(of_cube_on_plate(law)(0, 6), 2 * most / 0.25);
  const Tangent slow = of_cube_on_plate(law, {{0.125, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(slow(0, 6), most * (2 - 2 * 0.5) / 0.25);
  EXPECT_EQ(slow(1, 7), most * (2 - 0.5) / 0.25);
  const Tangent fast = of_cube_on_plate(law, {{0.25, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(fast(0, 6), 0);
  EXPECT_EQ(fast(1, 7), most / 0.25);
  EXPECT_EQ(fast(0, 2), 0.5 * 100 * kBottom);  // pressed more, it rubs more
}

TEST(Tangent, OfBodiesThatAreApartIsZeroForAPairingAndForAScene) {
  const Pose far = shifted(9, 0, 0);
  const Contact alone = test::answer(cube(), cube(), far, test::stiffness(1), Mode::both, {}, kTangent);
  ASSERT_TRUE(alone.tangent.has_value());
  EXPECT_TRUE(alone.tangent->isZero(0));
  Scene scene;
  for (int body = 0; body < 2; ++body) scene.add_body(Surface(cube()));
  scene.add_pairing(0, 1, test::stiffness(1), Mode::both, Scheme::barycentric, kTangent);
  scene.move({{}, {far, {}}});
  Workspace workspace;
  const Contact skipped = scene.evaluate(0, workspace);
  EXPECT_EQ(scene.counters().apart_by_boxes, 1);
  test::expect_same_answer(skipped, alone);
}

/// Two bubbles that move, some 2 cm deep in each other.
struct MovingBubbles {
  Scheme scheme;
  Surface bubble{generate::bubble()};
  Pose pose = test::turned(0.8, {0.13, 0.04, 0.12});
  Velocity velocity{{0.2, -0.3, -0.1}, {1, 2, -3}};

  Pairing pairing(Mode mode) const { return {bubble, bubble, test::rough(1000), mode, scheme}; }
};

class TangentOverSchemes : public testing::TestWithParam<Scheme> {};

INSTANTIATE_TEST_SUITE_P(Schemes, TangentOverSchemes, testing::Values(Scheme::barycentric, Scheme::clipped),
                         [](const auto& scheme) {
                           return scheme.param == Scheme::clipped ? "clipped" : "barycentric";
                         });

TEST_P(TangentOverSchemes, IsTheSameWhateverElseIsWantedAndSaved) {
  const MovingBubbles here{GetParam()};
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    const Pairing pairing = here.pairing(mode);
    Workspace workspace;
    const Contact alone = evaluate(pairing, here.pose, here.velocity, kTangent, workspace);
    ASSERT_GT(alone.tangent->norm(), 1e3);
    Wanted everything;
    everything.tangent = everything.bound = true;
    Savings none;
    none.lazy_vertices = none.one_sided = none.velocities = none.only_wanted = none.filters = false;
    const Contact whole = evaluate(pairing, here.pose, here.velocity, everything, workspace);
    ASSERT_TRUE(whole.tangent.has_value() && whole.bound.has_value());
    EXPECT_TRUE(test::same(*whole.tangent, *alone.tangent));
    test::expect_same_answer(evaluate(pairing, here.pose, here.velocity, everything, workspace, none), whole);
    test::expect_same_answer(evaluate(pairing, here.pose, here.velocity, kTangent, workspace, none), alone);
    everything.tangent = false;
    EXPECT_FALSE(evaluate(pairing, here.pose, here.velocity, everything, workspace, none).tangent.has_value());
  }
}

TEST_P(TangentOverSchemes, OfAKnownPoseWithAnotherVelocityIsThatOfAWholeEvaluation) {
  const MovingBubbles here{GetParam()};
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    PairingMemory memory(here.pairing(mode));
    Workspace workspace, other;
    memory.evaluate(here.pose, {}, kTangent, workspace);
    const Contact& known = memory.evaluate(here.pose, here.velocity, kTangent, workspace);
    // How parts of faces move is not kept.
    EXPECT_EQ(known.work.law_only, GetParam() == Scheme::barycentric ? 1 : 0);
    test::expect_same_answer(known, evaluate(here.pairing(mode), here.pose, here.velocity, kTangent, other));
    // What was found without a tangent in mind has no gradients, and what was found with one brings none unasked.
    Wanted force = kTangent;
    force.tangent = false;
    for (const auto& [first, second] : {std::pair(force, kTangent), std::pair(kTangent, force)}) {
      PairingMemory another(here.pairing(mode));
      another.evaluate(here.pose, {}, first, workspace);
      test::expect_same_answer(another.evaluate(here.pose, here.velocity, second, workspace),
                               evaluate(here.pairing(mode), here.pose, here.velocity, second, other));
    }
  }
}

TEST(Tangent, BeyondAllDoublesIsRefusedWhereTheForceIsNot) {
  // Far from Mf: the torque has one arm and the depth, its slope by a turn two arms.
  const TriangleMesh block = generate::box({64, -1, 0}, {66, 1, 2}), plate = generate::box({60, -2, -1}, {70, 2, 0});
  const ContactLaw law = test::stiffness(0x1p1020);
  const Pose pose = shifted(0, 0, 0x1p-10);
  Wanted force = kTangent;
  force.tangent = false;
  EXPECT_GT(test::answer(block, plate, pose, law, Mode::E, {}, force).force_Me.z(), 0);
  EXPECT_THROW(test::answer(block, plate, pose, law, Mode::E, {}, kTangent), BadInput);
}

TEST(Tangent, OfNumbersThatFourLanesCannotSquareIsScaledLikeTheForce) {
  // All lengths times s, stiffness by 1 / s, velocities times t, damping by 1 / t: forces times s^2.
  const double s = 0x1p-280, t = 0x1p-600;
  TriangleMesh tiny_cube = cube(), tiny_plate = raised_plate();
  for (TriangleMesh* mesh : {&tiny_cube, &tiny_plate})
    for (Eigen::Vector3d& x : mesh->vertices) x *= s;
  ContactLaw law = test::stiffness(100);
  law.damping = 8;
  law.friction = 0.5;
  law.slip_velocity = 0.25;
  Velocity velocity{{0.125, 0.25, 0.5}, {0, 0, 0}};
  const Tangent usual =
      *test::answer(cube(), raised_plate(), shifted(0, 0, kRaised), law, Mode::E, velocity, kTangent).tangent;
  law.stiffness /= s;
  law.damping /= t;
  law.slip_velocity *= t;
  velocity.v *= t;
  const Tangent tiny =
      *test::answer(tiny_cube, tiny_plate, shifted(0, 0, s * kRaised), law, Mode::E, velocity, kTangent).tangent;
  const auto by = [](const Tangent& tangent, int row, int column, double unit) {
    return Eigen::Matrix3d(tangent.block<3, 3>(row, column) / unit);
  };
  EXPECT_LT((by(tiny, 0, 0, s) - by(usual, 0, 0, 1)).norm(), 1e-13 * usual.norm());
  EXPECT_LT((by(tiny, 0, 6, s * s / t) - by(usual, 0, 6, 1)).norm(), 1e-13 * usual.norm());
  EXPECT_LT((by(tiny, 3, 0, s * s) - by(usual, 3, 0, 1)).norm(), 1e-13 * usual.norm());
}

}  // namespace
}  // namespace pcm::fast
