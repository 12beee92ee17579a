// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/force/law_parameters.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "pcm/bad_input.h"
#include "pcm/layer_stiffness.h"
#include "tests/fast/engine_support.h"

namespace pcm::fast {
namespace {

using Eigen::Vector3d;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void expect_refused(const std::function<void()>& action, const std::string& word) {
  try {
    action();
    FAIL() << "accepted, expected a message with: " << word;
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(Law, LayerModulusOfAnIncompressibleLayerIsRefused) {
  EXPECT_DOUBLE_EQ(layer_stiffness(1e6, 0, 0.5), 2e6);
  EXPECT_DOUBLE_EQ(layer_stiffness(1e6, 0.25, 1), 0.75 / (1.25 * 0.5) * 1e6);
  for (const double poisson : {0.45, 0.5, -1.0, kNaN, kInf}) {
    expect_refused([&] { layer_stiffness(1e6, poisson, 1); }, "Poisson");
  }
  for (const double young : {0.0, -1.0, kInf, kNaN}) expect_refused([&] { layer_stiffness(young, 0.3, 1); }, "Young");
  for (const double b : {0.0, -1.0, kInf, kNaN}) expect_refused([&] { layer_stiffness(1e6, 0.3, b); }, "thickness");
  // Infinite would mean rigid, and 0 is no layer.
  expect_refused([&] { layer_stiffness(1e300, 0.3, 1e-300); }, "stiffness K / b");
  expect_refused([&] { layer_stiffness(1e-300, 0.3, 1e10); }, "stiffness K / b");
}

TEST(Law, ParametersOutOfRangeAreRefusedByName) {
  const auto refused = [](const std::string& word, const std::function<void(ContactLaw&)>& change) {
    ContactLaw law;
    change(law);
    expect_refused([&] { require_valid(law); }, word);
  };
  for (const double bad : {-1.0, kInf, kNaN}) {
    refused("stiffness", [=](ContactLaw& law) { law.stiffness = bad; });
    refused("damping", [=](ContactLaw& law) { law.damping = bad; });
    refused("transition", [=](ContactLaw& law) { law.transition_depth = bad; });
    refused("friction", [=](ContactLaw& law) { law.friction = bad; });
    refused("slip", [=](ContactLaw& law) { law.slip_velocity = bad; });
  }
  refused("stiffness", [](ContactLaw& law) { law.stiffness = 0; });
  for (const double bad : {0.0, -1.0, kNaN}) {
    refused("max_penetration", [=](ContactLaw& law) { law.max_penetration = bad; });
    refused("c_E", [=](ContactLaw& law) { law.layers = LayerStiffness{bad, 1}; });
    refused("c_F", [=](ContactLaw& law) { law.layers = LayerStiffness{1, bad}; });
  }
  refused("rigid", [](ContactLaw& law) { law.layers = LayerStiffness{}; });
  EXPECT_NO_THROW(require_valid(ContactLaw{}));
}

TEST(Law, LayersInSeriesShareThePenetration) {
  ContactLaw law;
  law.layers = LayerStiffness{3, 1};
  const SeriesStiffness series(law);
  EXPECT_DOUBLE_EQ(series.c_l, 0.75);
  EXPECT_DOUBLE_EQ(series.shift_from_E, 0.25);
  EXPECT_DOUBLE_EQ(series.shift_from_F, 0.75);
  law.layers = LayerStiffness{kInf, 2};
  const SeriesStiffness rigid_E(law);
  EXPECT_EQ(rigid_E.c_l, 2);
  EXPECT_EQ(rigid_E.shift_from_E, 0);
  EXPECT_EQ(rigid_E.shift_from_F, 1);
}

TEST(Law, DampingFadesInAndNeverPulls) {
  ContactLaw law;
  law.damping = 10;
  law.transition_depth = 0.5;
  EXPECT_EQ(element_force(law, 100, 2, 1, 3, 0).normal, 200 + 60);
  EXPECT_EQ(element_force(law, 100, 2, 0.25, 3, 0).normal, 50 + 30);
  EXPECT_EQ(element_force(law, 100, 2, 1, -3, 0).normal, 200 - 60);
  EXPECT_EQ(element_force(law, 100, 2, 1, -30, 0).normal, 0);
  law.damping_mode = DampingMode::full;
  EXPECT_EQ(element_force(law, 100, 2, 1, -30, 0).normal, 200 - 600);
  law.damping_mode = DampingMode::compression;
  EXPECT_EQ(element_force(law, 100, 2, 1, -30, 0).normal, 200);
}

TEST(Law, FrictionIsRegularisedBelowTheSlipVelocity) {
  ContactLaw law;
  law.friction = 0.5;
  EXPECT_EQ(element_force(law, 1, 1, 8, 0, 0).tangential, 0);
  EXPECT_EQ(element_force(law, 1, 1, 8, 0, 1e-300).tangential, 4);
  law.slip_velocity = 2;
  EXPECT_EQ(element_force(law, 1, 1, 8, 0, 3).tangential, 4);
  EXPECT_EQ(element_force(law, 1, 1, 8, 0, 1).tangential, 4 * 0.5 * 1.5);
  law.damping = 100;
  EXPECT_EQ(element_force(law, 1, 1, 8, -1, 3).tangential, 0);
  law.damping_mode = DampingMode::full;
  EXPECT_EQ(element_force(law, 1, 1, 8, -1, 3).tangential, 0);
}

TEST(Law, FrictionOfWhatSticksIsZeroEvenWhereItsLimitOverflows) {
  ContactLaw law;
  law.friction = 1e308;
  EXPECT_EQ(element_force(law, 1, 1, 1e9, 0, 0).tangential, 0);
  law.slip_velocity = 1;
  EXPECT_EQ(element_force(law, 1, 1, 1e9, 0, 0).tangential, 0);
  EXPECT_EQ(element_force(law, 1, 1, 1e9, 0, 0.5).tangential, kInf);
}

TEST(Law, ElementsMoveWithTheBodyThatSlides) {
  // A box slides in +x on a wider one and approaches: its friction drags E along, E's top is pushed down.
  const TriangleMesh E = generate::plate(4, 4, 1);
  const TriangleMesh F = generate::box(Vector3d(1, 1, 1));
  ContactLaw law = test::stiffness(100);
  law.damping = 10;
  law.friction = 0.5;
  const Velocity velocity{{2, 0, -1}, {0, 0, 0}};
  const Contact contact = test::answer(E, F, shifted(0, 0, 0.25), law, Mode::F, velocity);
  EXPECT_DOUBLE_EQ(contact.force_Me.z(), -(100 * 0.25 + 10));
  EXPECT_DOUBLE_EQ(contact.force_Me.x(), 0.5 * 35);
  ASSERT_EQ(contact.elements.size(), 2u);
  EXPECT_DOUBLE_EQ(contact.elements[0].normal_velocity, 1);
  EXPECT_DOUBLE_EQ(contact.elements[0].tangential_velocity, 2);
  EXPECT_DOUBLE_EQ(contact.elements[0].position_Me.z(), -0.125);
  EXPECT_DOUBLE_EQ(contact.statistics.patch_area, 1);
  EXPECT_DOUBLE_EQ(contact.statistics.mean_pressure, 35);
}

TEST(Pose, AnythingButARotationIsRefused) {
  const Surface surface(generate::box(Vector3d(1, 1, 1)));
  const Pairing pairing(surface, surface);
  Workspace workspace;
  const auto evaluated = [&](const Pose& pose, const Velocity& velocity = {}) {
    return [&, pose, velocity] { evaluate(pairing, pose, velocity, {}, workspace); };
  };
  Pose pose;
  pose.A(0, 0) = 1 + 2e-9;
  expect_refused(evaluated(pose), "rotation");
  pose.A(0, 0) = 1 + 2e-10;
  EXPECT_NO_THROW(evaluated(pose)());
  pose.A(0, 0) = -1;
  expect_refused(evaluated(pose), "reflection");
  pose.A(0, 0) = kNaN;
  expect_refused(evaluated(pose), "finite");
  pose = {};
  pose.r[1] = kInf;
  expect_refused(evaluated(pose), "finite");
  expect_refused(evaluated({}, {{0, kNaN, 0}, {0, 0, 0}}), "velocity");
}

TEST(Velocity, BeyondWhatPointsCanHaveIsRefusedAndNoLesserOneLosesItsDirection) {
  const Surface slider(generate::box(Vector3d(0.5, 0.5, 0.5))), plate(generate::box(Vector3d(2, 2, 2)));
  ContactLaw law;
  law.friction = 0.5;
  Pose pose;
  pose.r = {0, 0, -1.1875};
  Workspace workspace;
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const Pairing pairing(slider, plate, law, Mode::E, scheme);
    const auto force = [&](double v, double w) -> Vector3d {
      return evaluate(pairing, pose, {{v, v, 0}, {0, 0, w}}, {}, workspace).force_Me;
    };
    const Vector3d slow = force(1, 0);
    EXPECT_GT(slow.x(), 0);
    EXPECT_EQ(force(0x1p700, 0), slow);
    EXPECT_THROW(force(0x1.1p700, 0), BadInput);
    EXPECT_THROW(force(-0x1.1p700, 0), BadInput);
    EXPECT_TRUE(force(0, 0x1p700).allFinite());
    EXPECT_THROW(force(0, 0x1.1p700), BadInput);
  }
}

}  // namespace
}  // namespace pcm::fast
