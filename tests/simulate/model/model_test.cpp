// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/model/model.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <string>

#include "simulate/scenes/read_scene.h"

namespace pcm::simulate {
namespace {

Model model_of(const std::string& text) {
  return Model(parse_scene(text, "test.json"));
}

Eigen::VectorXd derivative(Model& model, const Eigen::VectorXd& y) {
  Eigen::VectorXd dydt(model.size());
  EXPECT_EQ(model.derivative(0, y, dydt), Evaluation::available);
  return dydt;
}

TEST(Model, AFreeBodyStartsWhereAndAsTheSceneSays) {
  Model model = model_of(R"({
    "bodies": [{"name": "body", "mass": 2, "centre_of_mass": [0.1, 0.2, 0.3],
      "at": {"position": [1, 2, 3], "rotation": {"axis": [1, 2, 2], "angle": 0.8}},
      "velocity": [0.5, -1, 2], "angular_velocity": [3, 1, -2],
      "surfaces": [{"name": "box", "make": "box", "at": {"position": [0.5, 0, 0]}}]}],
    "ground": {"surfaces": [{"name": "floor", "make": "plate"}]},
    "laws": {"law": {"stiffness": 1e5}},
    "pairings": [{"E": "floor", "F": "box", "law": "law"}],
    "duration": 1, "gravity": [0, 0, 0]})");
  EXPECT_EQ(model.degrees_of_freedom(), 6);
  const Observation now = model.observe(0, model.start());
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 2).normalized()).toRotationMatrix();
  EXPECT_LT((now.surfaces_G[1 - 0].A - R).norm(), 1e-14);
  // In a moment the surface's origin has moved by its velocity, v + w x (R p).
  const double dt = 1e-6;
  const Eigen::VectorXd later = model.start() + dt * derivative(model, model.start());
  const Eigen::Vector3d arm = R * Eigen::Vector3d(0.5, 0, 0);
  const Eigen::Vector3d expected = Eigen::Vector3d(0.5, -1, 2) + Eigen::Vector3d(3, 1, -2).cross(arm);
  const std::size_t box = now.surfaces_G.size() - 1;
  const Eigen::Vector3d moved = (model.observe(dt, later).surfaces_G[box].r - now.surfaces_G[box].r) / dt;
  EXPECT_LT((now.surfaces_G[box].r - Eigen::Vector3d(1, 2, 3) - arm).norm(), 1e-14);
  EXPECT_LT((moved - expected).norm(), 1e-5);
}

// (1/2) m v^2 of the centre of mass, and m g h of it.
TEST(Model, EnergiesAreThoseOfTheCentreOfMass) {
  Model model = model_of(R"({
    "bodies": [{"name": "body", "mass": 2, "centre_of_mass": [0, 0, 0.5], "inertia": [1, 1, 1],
      "at": {"position": [0, 0, 3]}, "velocity": [0, 3, 0], "angular_velocity": [2, 0, 0]}],
    "duration": 1, "gravity": [0, 0, -10]})");
  const Energies energies = model.observe(0, model.start()).energies;
  EXPECT_NEAR(energies.kinetic, 0.5 * 2 * 4 + 0.5 * 4, 1e-12);  // v_c = (0, 3 - 2 * 0.5, 0)
  EXPECT_NEAR(energies.gravity, 2 * 10 * 3.5, 1e-12);
}

// A pendulum with its mass at the end of a rod, 1 m below a pin about y: d2q/dt2 = -g / l sin q.
TEST(Model, APinTurnsAboutZOfItsFrames) {
  Model model = model_of(R"({
    "bodies": [{"name": "rod", "mass": 2, "centre_of_mass": [0, 0, -1], "inertia": [1e-9, 1e-9, 1e-9],
      "joint": {"type": "pin", "in_parent": {"rotation": {"axis": [1, 0, 0], "angle": -1.5707963267948966}},
                "in_body": {"rotation": {"axis": [1, 0, 0], "angle": -1.5707963267948966}}, "coordinates": [0.3]}}],
    "duration": 1, "gravity": [0, 0, -9.81]})");
  EXPECT_EQ(model.size(), 2);
  EXPECT_NEAR(derivative(model, model.start())[1], -9.81 * std::sin(0.3), 1e-7);
}

TEST(Model, ABumperPushesBackBeyondItsLimitOnly) {
  const std::string before =
      R"({"bodies": [{"name": "cart", "mass": 2, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0],
    "joint": {"type": "slider", "damping": 4, "limits": [{"coordinate": 0, "from": -1, "to": 1, "stiffness": 100,
    "dissipation": 0.5}], "coordinates": [)";
  const std::string after = R"(], "speeds": [0.2]}}], "duration": 1})";
  const auto acceleration = [&](const std::string& x) {
    Model model = model_of(before + x + after);
    return derivative(model, model.start())[1];
  };
  EXPECT_NEAR(acceleration("0.99"), -0.4, 1e-12);                            // the damper's
  EXPECT_NEAR(acceleration("1.25"), -0.4 - 12.5 * (1 + 0.5 * 0.2), 1e-12);   // 25 N, and it moves on
  EXPECT_NEAR(acceleration("-1.25"), -0.4 + 12.5 * (1 - 0.5 * 0.2), 1e-12);  // 25 N, and it comes back
  Model model = model_of(before + "1.25" + after);
  const Observation now = model.observe(0, model.start());
  EXPECT_NEAR(now.energies.bumpers, 0.5 * 100 * 0.25 * 0.25, 1e-12);
  EXPECT_NEAR(now.powers.joints, 4 * 0.04 + 25 * 0.5 * 0.2 * 0.2, 1e-12);
}

TEST(Model, APrescribedBodyMovesOnSteadilyAndBringsEnergy) {
  Model model = model_of(R"({
    "bodies": [{"name": "car", "mass": 1000, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0],
      "joint": {"type": "slider", "prescribed_speed": 8, "damping": 10}}],
    "duration": 1})");
  EXPECT_EQ(model.degrees_of_freedom(), 0);
  const Eigen::VectorXd dydt = derivative(model, model.start());
  EXPECT_EQ(dydt[0], 8);
  EXPECT_EQ(dydt[1], 0);
  const Powers powers = model.observe(0, model.start()).powers;
  EXPECT_NEAR(powers.motions, 640, 1e-9);  // against the damper
  EXPECT_NEAR(powers.joints, 640, 1e-9);
}

TEST(Model, NormalisedStatesHaveQuaternionsOfLength1AndTheSamePlace) {
  Model model = model_of(R"({"bodies": [{"name": "body", "mass": 1, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0]}],
    "duration": 1})");
  Eigen::VectorXd y = model.start();
  y.head<4>() = Eigen::Vector4d(0.25, 0.5, 0.75, 1);
  y[5] = 7;
  const Eigen::VectorXd unit = model.normalised(y);
  EXPECT_NEAR(unit.head<4>().norm(), 1, 1e-15);
  EXPECT_NEAR(unit[3], 4 / std::sqrt(30.0), 1e-15);
  EXPECT_EQ(unit[5], 7);
}

TEST(Model, NormalisedStatesOfPrescribedJointsHaveTheScenesSpeed) {
  Model model = model_of(R"({"bodies": [
    {"name": "free", "mass": 1, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0]},
    {"name": "car", "mass": 1, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0],
     "joint": {"type": "slider", "prescribed_speed": 8}}], "duration": 1})");
  const Eigen::VectorXd y = model.start();
  EXPECT_EQ(y[y.size() - 1], 8);
  Eigen::VectorXd of_another_speed = y;
  of_another_speed[y.size() - 1] = 3;
  EXPECT_EQ(model.normalised(of_another_speed), y);
}

/// A block of 1 m and 10 kg that lies `depth` deep in the floor.
std::string block_in_floor(const std::string& height, const std::string& law, const std::string& velocity) {
  return R"({"laws": {"law": )" + law + R"(},
    "ground": {"surfaces": [{"name": "floor", "make": "plate", "parameters": {"extent_x": 4, "extent_y": 4, "thickness": 4}}]},
    "bodies": [{"name": "block", "mass": 10, "at": {"position": [0.05, 0.02, )" +
         height + R"(]}, "velocity": )" + velocity + R"(,
      "surfaces": [{"name": "block", "make": "box"}]}],
    "pairings": [{"E": "floor", "F": "block", "law": "law", "mode": "F"}], "duration": 1})";
}

TEST(Model, ContactPushesABlockOut) {
  Model model = model_of(block_in_floor("0.499", R"({"stiffness": 1e6})", "[0, 0, 0]"));
  EXPECT_NEAR(derivative(model, model.start())[9 + 3 - 1 + 1], 1e6 * 1e-3 / 10 - 9.81, 1e-6);
}

TEST(Model, DampingAndFrictionTakeTheirPower) {
  Model model = model_of(block_in_floor(
      "0.499", R"({"stiffness": 1e6, "damping": 1e4, "friction": 0.5, "slip_velocity": 1e-3})", "[0.3, 0, -0.01]"));
  const Observation now = model.observe(0, model.start());
  EXPECT_NEAR(now.pairings[0].normal_force, 1000 + 100, 1e-6);
  EXPECT_NEAR(now.pairings[0].tangential_force, 550, 1e-6);
  EXPECT_NEAR(now.powers.damping, 100 * 0.01, 1e-8);
  EXPECT_NEAR(now.powers.friction, 550 * 0.3, 1e-6);
  EXPECT_NEAR(now.energies.elastic, 0.5, 1e-8);
}

TEST(Model, AForceThatPullsIsShownWhereItPulls) {
  Model model =
      model_of(block_in_floor("0.499", R"({"stiffness": 1e6, "damping": 1e5, "damping_mode": "full"})", "[0, 0, 1]"));
  const PairingObservation pairing = model.observe(0, model.start()).pairings[0];
  EXPECT_NEAR(pairing.normal_force, 1000 - 100000, 1e-6);
  EXPECT_NEAR(pairing.centre_of_force_G.x(), 0.05, 1e-9);
  EXPECT_NEAR(pairing.centre_of_force_G.y(), 0.02, 1e-9);
}

TEST(Model, AnswersNotHereWhereBodiesAreNestedOrTooDeep) {
  Eigen::VectorXd dydt(13);
  Model nested = model_of(block_in_floor("-2", R"({"stiffness": 1e6})", "[0, 0, 0]"));
  EXPECT_EQ(nested.derivative(0, nested.start(), dydt), Evaluation::not_here);
  EXPECT_EQ(nested.counters().nested, 1);
  Model deep = model_of(block_in_floor("0.49", R"({"stiffness": 1e6, "max_penetration": 0.005})", "[0, 0, 0]"));
  EXPECT_EQ(deep.derivative(0, deep.start(), dydt), Evaluation::not_here);
  EXPECT_EQ(deep.counters().penetration_exceeded, 1);
}

}  // namespace
}  // namespace pcm::simulate
