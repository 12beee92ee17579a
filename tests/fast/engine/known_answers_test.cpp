// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "fast/force/law_parameters.h"
#include "tests/fast/engine_support.h"

/// Closed forms of the model that the barycentric scheme meets: exactly where whole faces are in contact, as the
/// penetration is linear over each, and within the meshes' resolution elsewhere.
namespace pcm::fast::known_answers_test {
namespace {

using namespace test;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

TEST(KnownAnswers, BoxOnPlateIsStiffnessTimesAreaTimesDepthWithEitherMaster) {
  // The plate's grid lines run along the box's sides. The side walls carry nothing.
  const TriangleMesh plate = generate::plate(2, 2, 1, 8, 8);
  const TriangleMesh cube = generate::box(Vector3d(-0.25, -0.25, 0), Vector3d(0.25, 0.25, 0.5));
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    const Contact contact = answer(plate, cube, shifted(0, 0, -0.05), stiffness(100), mode);
    EXPECT_NEAR(contact.force_Me.z(), -1.25, 1e-14);
    EXPECT_NEAR(contact.force_Me.head<2>().norm(), 0, 1e-15);
    EXPECT_NEAR(contact.max_penetration, 0.05, 1e-16);
    EXPECT_EQ(contact.too_deep, 0);
  }
}

TEST(KnownAnswers, WedgeAsMasterIsPushedSidewaysWithoutFriction) {
  // Sunk by half its height, along a row of its grid.
  const double K = 3, w = 1, h = 0.5;
  for (const double degrees : {15.0, 30.0, 40.0, 45.0, 70.0}) {
    const double p = degrees * kPi / 180;
    const TriangleMesh wedge = generate::wedge(degrees, 1, w, 8);
    const TriangleMesh plate = generate::plate(20, 20, 5);
    const double expected_z = K * w * h * h / 2 * (1 / std::sin(p) + 1 / std::cos(p));
    const Contact as_E = answer(wedge, plate, shifted(0, 0, h), stiffness(K));
    EXPECT_NEAR(as_E.force_Me.z(), expected_z, 1e-12);
    EXPECT_NEAR(as_E.force_Me.x() / as_E.force_Me.z(), std::tan(p - kPi / 4), 1e-12);
    EXPECT_NEAR(as_E.force_Me.y(), 0, 1e-12);
    const Contact as_F = answer(plate, wedge, shifted(0, 0, -h), stiffness(K), Mode::F);
    EXPECT_NEAR(as_F.force_Me.z(), -expected_z, 1e-12);
    EXPECT_NEAR(as_F.force_Me.x() / as_F.force_Me.z(), std::tan(p - kPi / 4), 1e-12);
  }
}

TEST(KnownAnswers, PlateAsMasterFeelsTheImmersedVolumeThroughItsCentroid) {
  // A wedge of 45 degrees stands on its edge; the plate's grid follows its outline, so u is linear over each face.
  // Barycentres sample the force exactly, its arm to the square of the grid's width.
  const double K = 7, h = 0.5;
  const TriangleMesh wedge = translated(generate::wedge(45, 1, 1), {0, 0, -h});
  double y = 0;
  for (const Vector3d& x : wedge.vertices) y += x.y() / static_cast<double>(wedge.vertices.size());
  const Contact contact = answer(generate::plate(4, 4, 1, 64, 64), wedge, shifted(0.25, 0.5, 0), stiffness(K));
  const double force = -K * h * h;
  EXPECT_NEAR(contact.volume, h * h, 1e-14);
  EXPECT_NEAR(contact.force_Me.z(), force, 1e-13);
  EXPECT_NEAR(contact.force_Me.head<2>().norm(), 0, 1e-13);
  // About Mf, which stands above the ridge.
  EXPECT_NEAR(contact.torque_Me.x(), y * force, 1e-2 * std::abs(force));
  EXPECT_NEAR(contact.torque_Me.y(), 0, 1e-2 * std::abs(force));
}

TEST(KnownAnswers, SphereOnPlateTendsToTheClosedFormOfEachMaster) {
  // Sphere master K pi r h^2, plate master K pi h^2 (r - h / 3), both K pi h^2 (r - h / 6); inscribed meshes are of
  // second order.
  const double K = 1, r = 1, h = 0.2;
  const auto error = [&](Index level, Mode mode, double expected) {
    const TriangleMesh plate = generate::plate(2, 2, 2, 10 << (level - 3), 10 << (level - 3));
    const TriangleMesh sphere = generate::icosphere(r, level);
    const Contact pressed = answer(sphere, plate, shifted(0.013, 0.007, -(r - h)), stiffness(K), mode);
    return std::abs(pressed.force_Me.z() / expected - 1);
  };
  const double sphere = K * kPi * r * h * h, plate = K * kPi * h * h * (r - h / 3);
  EXPECT_LT(error(5, Mode::E, sphere), 0.005);
  EXPECT_LT(error(5, Mode::E, sphere), 0.5 * error(4, Mode::E, sphere));
  EXPECT_LT(error(5, Mode::F, plate), 0.01);
  EXPECT_LT(error(5, Mode::both, 0.5 * (sphere + plate)), 0.01);
}

TEST(KnownAnswers, SplittingSlaveFacesInTheirPlaneChangesNoElasticForce) {
  const TriangleMesh sphere = generate::icosphere(1, 3);
  const Pose pose = turned(0.4, {0.1, 0.2, -0.8});
  const Contact whole = answer(sphere, generate::plate(4, 4, 1), pose);
  const Contact split = answer(sphere, generate::plate(4, 4, 1, 32, 32), pose);
  ASSERT_GT(whole.element_count, 20);
  EXPECT_EQ(split.element_count, whole.element_count);
  EXPECT_LT((split.force_Me - whole.force_Me).norm(), 1e-14 * whole.force_Me.norm());
  EXPECT_LT((split.torque_Me - whole.torque_Me).norm(), 1e-14 * whole.force_Me.norm());
}

TEST(KnownAnswers, PlateUnderALargeFaceFeelsNothingOfThePinBesideIt) {
  // One surface of two components: a plate sunk by 1/8, and a pin that reaches the large face or not.
  const TriangleMesh floor = generate::box(Vector3d(-8, -8, -4), Vector3d(8, 8, 0));
  const auto force = [&](double pin_bottom) {
    TriangleMesh body = generate::box(Vector3d(-1, -1, -0.125), Vector3d(1, 1, 1));
    const TriangleMesh pin = generate::box(Vector3d(2, 0, pin_bottom), Vector3d(2.5, 0.5, 1));
    const auto first = static_cast<Index>(body.vertices.size());
    body.vertices.insert(body.vertices.end(), pin.vertices.begin(), pin.vertices.end());
    for (const Triangle& t : pin.faces) body.faces.push_back({t[0] + first, t[1] + first, t[2] + first});
    return answer(body, floor).force_Me.z();
  };
  EXPECT_EQ(force(0.25), 0.125 * 4);
  EXPECT_EQ(force(0x1p-50), 0.125 * 4);
  EXPECT_EQ(force(-0x1p-50), 0.125 * 4 + 0x1p-52);
  EXPECT_EQ(force(-0.0625), 0.125 * 4 + 0.0625 * 0.25);
}

TEST(KnownAnswers, CreepOnAnInclineHasTheSpeedWhereFrictionCarriesTheSlope) {
  // tan a < mu: v = v_eps (1 - sqrt(1 - tan a / mu)); .5528 v_eps for mu = .25, tan a = .2.
  ContactLaw law;
  law.friction = 0.25;
  law.slip_velocity = 0.02;
  const double v = law.slip_velocity * (1 - std::sqrt(1 - 0.2 / law.friction));
  EXPECT_NEAR(v / law.slip_velocity, 0.5528, 5e-5);
  const ElementForce force = element_force(law, 1e6, 0.3, 0.01, 0, v);
  EXPECT_NEAR(force.tangential / force.normal, 0.2, 1e-15);
}

TEST(KnownAnswers, StoppingDistanceOfASlidingBodyIsTheIntegralOfItsFriction) {
  // v0^2 / (2 mu g) + v_eps^2 / (mu g) (ln 2 - 1/2), from dx = -v dv / a; below v_eps, a = mu g s (2 - s), s = v/v_eps.
  ContactLaw law;
  law.friction = 0.3;
  law.slip_velocity = 0.5;
  const double g = 9.81, v0 = 2, mu_g = law.friction * g;
  const int steps = 200000;
  double distance = 0;
  for (int i = 0; i < steps; ++i) {
    const double v = (i + 0.5) * v0 / steps;
    const ElementForce force = element_force(law, 1, 1, 1, 0, v);
    distance += v / (g * force.tangential / force.normal) * v0 / steps;
  }
  const double expected = v0 * v0 / (2 * mu_g) + law.slip_velocity * law.slip_velocity / mu_g * (std::log(2.0) - 0.5);
  EXPECT_NEAR(distance / expected, 1, 1e-8);
}

}  // namespace
}  // namespace pcm::fast::known_answers_test
