// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "reference/oracle.h"
#include "tests/reference/poses.h"
#include "tests/reference/problems.h"

namespace pcm::reference {
namespace {

const double kInfinite = std::numeric_limits<double>::infinity();

ContactLaw stiffness(double c_l) {
  ContactLaw law;
  law.stiffness = c_l;
  return law;
}

/// A cube of edge 1/2, its bottom at z = 0, above a wide plate with its top at z = 0: pressed in by moving the plate
/// up.
const TriangleMesh& cube() {
  static const TriangleMesh mesh = generate::box({-0.25, -0.25, 0}, {0.25, 0.25, 0.5});
  return mesh;
}
const TriangleMesh& plate() {
  static const TriangleMesh mesh = generate::box({-2, -2, -1}, {2, 2, 0});
  return mesh;
}

TEST(OracleForce, BoxOnPlateIsStiffnessTimesAreaTimesDepth) {
  const Oracle oracle(cube(), plate(), stiffness(100));
  for (const Problem problem : kProblems) {
    const Answer answer = oracle.answer(problem, shifted(0.125, 0.0625, 0.0625));
    EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, 100 * 0.25 * 0.0625));
    EXPECT_EQ(answer.elements.size(), 2u);  // the walls contribute nothing
    EXPECT_EQ(answer.max_penetration, 0.0625);
    EXPECT_EQ(answer.force_scale, 100 * 0.25 * 0.0625);
    // About Mf: arm from (0.125, 0.0625) to the axis of the cube.
    EXPECT_EQ(answer.torque_Me, Eigen::Vector3d(-0.0625, 0.125, 0) * answer.force_Me.z());
    EXPECT_TRUE(answer.certified);
    EXPECT_EQ(answer.too_deep, 0);
    for (const Element& element : answer.elements) {
      EXPECT_EQ(element.area, 0.125);
      EXPECT_EQ(element.penetration, 0.0625);
      EXPECT_EQ(element.cosine, -1);
      EXPECT_EQ(element.position_Me.z(), 0.03125);  // halfway (13)
    }
  }
}

TEST(OracleForce, FlushFlanksCarryNothing) {
  const TriangleMesh lower = generate::box({0, 0, 0}, {2, 2, 2}), upper = generate::box({0, 0, 1}, {2, 2, 3});
  for (const Problem problem : kProblems) {
    EXPECT_EQ(Oracle(lower, upper, stiffness(1)).answer(problem, {}).force_Me, Eigen::Vector3d(0, 0, -4));
    EXPECT_EQ(Oracle(upper, lower, stiffness(1)).answer(problem, {}).force_Me, Eigen::Vector3d(0, 0, 4));
  }
}

TEST(OracleForce, RestingBoxCarriesNothing) {
  for (const Problem problem : kProblems) {
    const Answer answer = Oracle(cube(), plate()).answer(problem, {});
    EXPECT_TRUE(answer.elements.empty());
    EXPECT_EQ(answer.force_Me, Eigen::Vector3d(0, 0, 0));
    EXPECT_EQ(answer.torque_Me, Eigen::Vector3d(0, 0, 0));
  }
}

TEST(OracleForce, ExchangedBodiesGiveTheOppositeForce) {
  const Pose pose = shifted(0.125, 0.0625, 0.0625);
  Pose inverse = pose;
  inverse.r = -pose.r;
  const Answer E = Oracle(cube(), plate(), stiffness(100), Mode::E).answer(Problem::rounded, pose);
  const Answer F = Oracle(plate(), cube(), stiffness(100), Mode::F).answer(Problem::rounded, inverse);
  EXPECT_EQ(F.force_Me, -E.force_Me);
  EXPECT_EQ(F.elements.size(), E.elements.size());
  EXPECT_EQ(F.max_penetration, E.max_penetration);
}

TEST(OracleForce, ModeBothIsTheMean) {
  const TriangleMesh sphere = generate::icosphere(1, 2);
  ContactLaw law = stiffness(1e5);
  law.damping = 100;
  law.friction = 0.25;
  law.slip_velocity = 0.01;
  Velocity velocity;
  velocity.v = {0.5, 0.25, -0.125};
  velocity.w = {0.1, -0.2, 0.3};
  const Pose pose = shifted(0.3, 0.2, 1.6);
  Answer answers[3];
  for (const Mode mode : {Mode::E, Mode::F, Mode::both})
    answers[static_cast<int>(mode)] = Oracle(sphere, sphere, law, mode).answer(Problem::exact, pose, velocity);
  EXPECT_FALSE(answers[0].elements.empty());
  EXPECT_EQ(answers[2].elements.size(), answers[0].elements.size() + answers[1].elements.size());
  EXPECT_NEAR(0, (answers[2].force_Me - (answers[0].force_Me + answers[1].force_Me) / 2).norm(),
              1e-15 * answers[2].force_scale);
  EXPECT_NEAR(0, (answers[2].torque_Me - (answers[0].torque_Me + answers[1].torque_Me) / 2).norm(),
              1e-15 * answers[2].torque_scale);
}

TEST(OracleForce, LayersInSeriesPlaceTheContactBetweenTheFaces) {
  const Pose pose = shifted(0, 0, 0.0625);
  ContactLaw law;
  law.layers = LayerStiffness{100, 300};
  Answer answer = Oracle(cube(), plate(), law).answer(Problem::rounded, pose);
  EXPECT_EQ(answer.force_Me.z(), 75 * 0.25 * 0.0625);
  EXPECT_EQ(answer.elements[0].position_Me.z(), 0.75 * 0.0625);
  law.layers = LayerStiffness{kInfinite, 300};
  answer = Oracle(cube(), plate(), law).answer(Problem::rounded, pose);
  EXPECT_EQ(answer.force_Me.z(), 300 * 0.25 * 0.0625);
  EXPECT_EQ(answer.elements[0].position_Me.z(), 0);
  law.layers = LayerStiffness{100, kInfinite};
  answer = Oracle(cube(), plate(), law).answer(Problem::rounded, pose);
  EXPECT_EQ(answer.elements[0].position_Me.z(), 0.0625);
}

TEST(OracleForce, DampingFadesInAndNeverPulls) {
  const Pose pose = shifted(0, 0, 0.0625);
  ContactLaw law = stiffness(100);
  law.damping = 8;
  Velocity velocity;
  velocity.v = {0, 0, 0.5};  // the plate moves up: approaching
  const double elastic = 100 * 0.25 * 0.0625, damping = 8 * 0.25 * 0.5;
  EXPECT_EQ(Oracle(cube(), plate(), law).answer(Problem::exact, pose, velocity).force_Me.z(), elastic + damping);
  law.transition_depth = 0.125;
  EXPECT_EQ(Oracle(cube(), plate(), law).answer(Problem::exact, pose, velocity).force_Me.z(), elastic + damping / 2);
  law.transition_depth = 0;
  velocity.v.z() = -4;
  EXPECT_EQ(Oracle(cube(), plate(), law).answer(Problem::exact, pose, velocity).force_Me.z(), 0);
  law.damping_mode = DampingMode::full;
  EXPECT_EQ(Oracle(cube(), plate(), law).answer(Problem::exact, pose, velocity).force_Me.z(), elastic - 8 * 0.25 * 4);
  law.damping_mode = DampingMode::compression;
  EXPECT_EQ(Oracle(cube(), plate(), law).answer(Problem::exact, pose, velocity).force_Me.z(), elastic);
}

TEST(OracleForce, FrictionIsRegularisedBelowTheSlipVelocity) {
  const Pose pose = shifted(0, 0, 0.0625);
  ContactLaw law = stiffness(100);
  law.friction = 0.5;
  law.slip_velocity = 1;
  const double normal = 100 * 0.25 * 0.0625;
  const auto drag = [&](double v) {
    Velocity velocity;
    velocity.v = {v, 0, 0};
    return Oracle(cube(), plate(), law).answer(Problem::exact, pose, velocity).force_Me.x();
  };
  EXPECT_EQ(drag(0.5), 0.5 * normal * 0.75);
  EXPECT_EQ(drag(1), 0.5 * normal);
  EXPECT_EQ(drag(4), 0.5 * normal);
  EXPECT_EQ(drag(0), 0);
  law.slip_velocity = 0;
  EXPECT_EQ(drag(0x1p-60), 0.5 * normal);
  EXPECT_EQ(drag(0), 0);
}

TEST(OracleForce, PenetrationBeyondTheBoundIsClampedAndFlagged) {
  ContactLaw law = stiffness(100);
  law.max_penetration = 0.0625;
  Answer answer = Oracle(cube(), plate(), law).answer(Problem::exact, shifted(0, 0, 0.125));
  EXPECT_TRUE(answer.penetration_exceeded);
  EXPECT_EQ(answer.force_Me.z(), 100 * 0.25 * 0.0625);
  EXPECT_EQ(answer.max_penetration, 0.125);
  answer = Oracle(cube(), plate(), law).answer(Problem::exact, shifted(0, 0, 0.0625));
  EXPECT_FALSE(answer.penetration_exceeded);
}

TEST(OracleForce, ThinMasterDeepInTheSlaveIsTooDeep) {
  const TriangleMesh sheet = generate::box({-0.25, -0.25, 0}, {0.25, 0.25, 0.0625});
  const Answer answer = Oracle(sheet, plate()).answer(Problem::rounded, shifted(0, 0, 0.5));
  EXPECT_TRUE(answer.nested);
  EXPECT_TRUE(answer.elements.empty());
  EXPECT_GE(answer.too_deep, 2);
}

TEST(OracleForce, RotatedPoseDifferenceOfTheProblemsIsRounding) {
  std::mt19937_64 random(11);
  SCOPED_TRACE("seed 11");
  const TriangleMesh sphere = generate::icosphere(1, 2);
  const Oracle oracle(sphere, sphere, stiffness(1e5));
  int elements = 0, certified = 0;
  for (int i = 0; i < 10; ++i) {
    const Pose pose = random_pose(random, 1.2);
    const Answer rounded = oracle.answer(Problem::rounded, pose), exact = oracle.answer(Problem::exact, pose);
    elements += static_cast<int>(rounded.elements.size());
    certified += rounded.certified;
    if (!rounded.certified) continue;
    ASSERT_EQ(rounded.elements.size(), exact.elements.size());
    EXPECT_NEAR(0, (rounded.force_Me - exact.force_Me).norm(), 1e-12 * exact.force_scale);
  }
  EXPECT_GT(elements, 100);
  EXPECT_GE(certified, 8);
}

/// The base of a tetrahedron, its barycentre above the origin, pressed into a plate whose top's diagonal passes through
/// the origin: which of the plate's two faces the line meets depends on how the turned plate's corners are rounded.
TEST(OracleForce, LineThroughAnEdgeOfATurnedSlaveIsNotCertified) {
  TriangleMesh tetrahedron;
  tetrahedron.vertices = {{0.5, -0.25, 0}, {-0.25, 0.5, 0}, {-0.25, -0.25, 0}, {0.0625, 0.03125, 0.5}};
  tetrahedron.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Oracle oracle(tetrahedron, plate(), stiffness(64));
  for (const Problem problem : kProblems) {
    Pose turned = shifted(0, 0, 0.0625);
    turned.A << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
    const Answer through_edge = oracle.answer(problem, turned);
    EXPECT_FALSE(through_edge.certified);
    EXPECT_EQ(through_edge.elements.size(), 1u);
    EXPECT_EQ(through_edge.force_Me.z(), 64 * 0.28125 * 0.0625);

    turned.r = {0.125, 0, 0.0625};
    const Answer through_face = oracle.answer(problem, turned);
    EXPECT_TRUE(through_face.certified);
    EXPECT_EQ(through_face.force_Me, through_edge.force_Me);

    // Not turned, no vertex is rounded: the tie rule decides for all of it.
    EXPECT_EQ(oracle.answer(problem, shifted(0, 0, 0.0625)).elements.size(), 1u);
  }
}

}  // namespace
}  // namespace pcm::reference
