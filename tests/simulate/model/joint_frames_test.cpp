// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where joints with turned and moved frames put a body, and how it moves there, against matrices made by hand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>

#include "simulate/model/model.h"
#include "simulate/scenes/read_scene.h"

namespace pcm::simulate {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

/// J in the parent and K in the body, as in `kFrames`.
const Isometry3d kX_PJ = Translation3d(0.1, -0.2, 0.3) * AngleAxisd(0.7, Vector3d(1, 2, 2).normalized());
const Isometry3d kX_BK = Translation3d(0.4, 0.5, -0.6) * AngleAxisd(-1.1, Vector3d(2, -1, 2).normalized());
const std::string kFrames =
    R"("in_parent": {"position": [0.1, -0.2, 0.3], "rotation": {"axis": [1, 2, 2], "angle": 0.7}},
    "in_body": {"position": [0.4, 0.5, -0.6], "rotation": {"axis": [2, -1, 2], "angle": -1.1}})";

const std::string kMass = R"("mass": 1, "inertia": [1, 1.2, 1.1], "centre_of_mass": [0, 0, 0])";
/// On every body, so that its pose can be observed.
std::string box(const std::string& name) {
  return R"("surfaces": [{"name": ")" + name + R"(", "make": "box"}])";
}

Isometry3d pose_of(Model& model, const Eigen::VectorXd& y, std::size_t surface) {
  const Pose pose = model.observe(0, y).surfaces_G[surface];
  Isometry3d X;
  X.linear() = pose.A;
  X.translation() = pose.r;
  return X;
}

Model one_joint(const std::string& type, const std::string& coordinates) {
  return Model(parse_scene(R"({"bodies": [{"name": "body", )" + kMass + ", " + box("body") + R"(,
      "joint": {"type": ")" + type +
                               R"(", )" + kFrames + coordinates + "}}], \"duration\": 1}",
                           "test.json"));
}

Isometry3d turned(const std::vector<std::pair<double, Vector3d>>& turns) {
  Isometry3d X = Isometry3d::Identity();
  for (const auto& [angle, axis] : turns) X = X * AngleAxisd(angle, axis);
  return X;
}

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

TEST(Joints, PutTheBodyWhereTheirCoordinatesSay) {
  struct Case {
    std::string type, coordinates;
    Isometry3d X_JK;
  };
  const std::vector<Case> cases{
      {"weld", "", Isometry3d::Identity()},
      {"ball", "", Isometry3d::Identity()},
      {"pin", R"(, "coordinates": [0.4])", turned({{0.4, kZ}})},
      {"slider", R"(, "coordinates": [0.4])", Isometry3d(Translation3d(0.4, 0, 0))},
      {"universal", R"(, "coordinates": [0.4, -0.9])", turned({{0.4, kX}, {-0.9, kY}})},
      {"gimbal", R"(, "coordinates": [0.4, -0.9, 1.3])", turned({{0.4, kX}, {-0.9, kY}, {1.3, kZ}})}};
  for (const Case& tested : cases) {
    SCOPED_TRACE(tested.type);
    Model model = one_joint(tested.type, tested.coordinates);
    const Isometry3d expected = kX_PJ * tested.X_JK * kX_BK.inverse();
    EXPECT_LT((pose_of(model, model.start(), 0).matrix() - expected.matrix()).norm(), 1e-14);
  }
}

// Speeds are the rates of the coordinates.
TEST(Joints, MoveTheirCoordinatesAtTheirSpeeds) {
  for (const auto& [type, count] :
       {std::pair("pin", 1), std::pair("slider", 1), std::pair("universal", 2), std::pair("gimbal", 3)}) {
    SCOPED_TRACE(type);
    std::string coordinates, speeds;
    for (int i = 0; i < count; ++i) {
      coordinates += (i > 0 ? ", 0." : "0.") + std::to_string(3 + i);
      speeds += (i > 0 ? ", -1." : "-1.") + std::to_string(4 + i);
    }
    Model model = one_joint(type, R"(, "coordinates": [)" + coordinates + R"(], "speeds": [)" + speeds + "]");
    Eigen::VectorXd dydt(model.size());
    ASSERT_EQ(model.derivative(0, model.start(), dydt), Evaluation::available);
    for (int i = 0; i < count; ++i) EXPECT_NEAR(dydt[i], -1.4 - 0.1 * i, 1e-15) << i;
  }
}

/// A body with a free joint on `parent`, turned and moving in G whatever its parent does.
std::string free_body_on(const std::string& parent) {
  return R"({"name": "body", )" + kMass + ", " + box("body") + R"(,
    "joint": {"type": "free", "parent": ")" +
         parent + "\", " + kFrames + R"(},
    "at": {"position": [1, 2, 3], "rotation": {"axis": [1, 2, 2], "angle": 0.8}},
    "velocity": [0.5, -1, 2], "angular_velocity": [3, 1, -2]})";
}

/// Its place, and by central differences along dq/dt its velocity.
void expect_free_body(Model& model, std::size_t surface) {
  const Eigen::VectorXd y = model.start();
  const Isometry3d X = pose_of(model, y, surface);
  const Isometry3d expected = Translation3d(1, 2, 3) * AngleAxisd(0.8, Vector3d(1, 2, 2).normalized());
  EXPECT_LT((X.matrix() - expected.matrix()).norm(), 1e-13);
  Eigen::VectorXd dydt(model.size());
  ASSERT_EQ(model.derivative(0, y, dydt), Evaluation::available);
  const double dt = 1e-5;
  const Isometry3d before = pose_of(model, model.normalised(y - dt * dydt), surface);
  const Isometry3d after = pose_of(model, model.normalised(y + dt * dydt), surface);
  const Vector3d v = (after.translation() - before.translation()) / (2 * dt);
  const Eigen::Matrix3d W = (after.linear() - before.linear()) / (2 * dt) * X.linear().transpose();
  EXPECT_LT((v - Vector3d(0.5, -1, 2)).norm(), 1e-8);
  EXPECT_LT((Vector3d(W(2, 1), W(0, 2), W(1, 0)) - Vector3d(3, 1, -2)).norm(), 1e-8);
}

TEST(Joints, FreeOneWithTurnedFramesStartsInGAsTheSceneSays) {
  Model model(parse_scene(R"({"bodies": [)" + free_body_on("ground") + R"(], "duration": 1})", "test.json"));
  expect_free_body(model, 0);
}

TEST(Joints, FreeOneOnATurningParentStartsInGAsTheSceneSays) {
  for (
      const char* parent_joint :
      {R"({"type": "pin", "coordinates": [0.7], "speeds": [1.5], "in_parent": {"position": [1, 0, 2], "rotation": {"axis": [1, 1, 0], "angle": 1}}})",
       R"({"type": "pin", "coordinates": [0.7], "prescribed_speed": -2, "in_body": {"position": [0.3, 0.2, 0.1]}})",
       R"({"type": "gimbal", "coordinates": [0.7, 0.2, -0.3], "speeds": [1.5, 2, -1]})"}) {
    SCOPED_TRACE(parent_joint);
    Model model(parse_scene(R"({"bodies": [{"name": "parent", )" + kMass + ", " + box("parent") + R"(, "joint": )" +
                                parent_joint + "}, " + free_body_on("parent") +
                                R"(], "duration": 1, "gravity": [0, 0, 0]})",
                            "test.json"));
    expect_free_body(model, 1);
  }
}

// Torque-free, about its centre of mass: I dw/dt = -w x I w, in B's axes, products of inertia included.
TEST(Joints, FreeOneTurnsByEulersEquations) {
  Model model(parse_scene(R"({"bodies": [{"name": "body", "mass": 2, "inertia": [2, 3, 4, 0.3, -0.2, 0.1],
      "centre_of_mass": [0.1, 0.4, -0.3], "at": {"rotation": {"axis": [1, 2, 2], "angle": 0.8}},
      "angular_velocity": [3, 1, -2]}], "duration": 1, "gravity": [0, 0, 0]})",
                          "test.json"));
  Eigen::VectorXd dydt(model.size());
  ASSERT_EQ(model.derivative(0, model.start(), dydt), Evaluation::available);
  Eigen::Matrix3d I;
  I << 2, 0.3, -0.2, 0.3, 3, 0.1, -0.2, 0.1, 4;
  const Eigen::Matrix3d R = AngleAxisd(0.8, Vector3d(1, 2, 2).normalized()).toRotationMatrix();
  const Eigen::Matrix3d I_G = R * I * R.transpose();
  const Vector3d w(3, 1, -2), alpha = I_G.inverse() * -w.cross(I_G * w);
  EXPECT_LT((Vector3d(dydt.segment<3>(7)) - alpha).norm(), 1e-13);  // coordinates: 4 of the quaternion, 3 of the place
  // The centre of mass has no acceleration: a = -alpha x c - w x (w x c).
  const Vector3d c = R * Vector3d(0.1, 0.4, -0.3);
  EXPECT_LT((Vector3d(dydt.segment<3>(10)) + alpha.cross(c) + w.cross(w.cross(c))).norm(), 1e-13);
}

// A plate of 1 m thickness, turned with all that lies on it; a block 1 mm deep in it: 1000 N over 1 m^2.
TEST(Observations, OfATurnedContactAreInGAndOnceInModeBoth) {
  for (const char* mode : {"E", "F", "both"}) {
    SCOPED_TRACE(mode);
    const std::string placed = R"(, "rotation": {"axis": [1, 2, 2], "angle": 0.8}})";
    Model model(parse_scene(R"({"laws": {"law": {"stiffness": 1e6}},
      "ground": {"surfaces": [{"name": "floor", "make": "plate", "parameters": {"extent_x": 4, "extent_y": 4, "thickness": 1},
                               "at": {"position": [0, 0, 0])" +
                                placed + R"(}]},
      "bodies": [{"name": "block", "mass": 1, "at": {"position": [0, 0, 0])" +
                                placed + R"(,
        "surfaces": [{"name": "block", "make": "box", "at": {"position": [0.1, 0.2, 0.499]}}]}],
      "pairings": [{"E": "floor", "F": "block", "law": "law", "scheme": "clipped", "mode": ")" +
                                mode + R"("}],
      "duration": 1})",
                            "test.json"));
    const Observation now = model.observe(0, model.start());
    const PairingObservation& pairing = now.pairings[0];
    const Eigen::Matrix3d R = AngleAxisd(0.8, Vector3d(1, 2, 2).normalized()).toRotationMatrix();
    EXPECT_LT((pairing.force_G - R * Vector3d(0, 0, -1000)).norm(), 1e-8);
    EXPECT_LT((pairing.centre_of_force_G - R * Vector3d(0.1, 0.2, -5e-4)).norm(), 1e-8);
    EXPECT_NEAR(pairing.normal_force, 1000, 1e-8);
    EXPECT_NEAR(pairing.patch_area, 1, 1e-9);
    EXPECT_GT(now.elements.size(), 1U);
    for (const ObservedElement& e : now.elements) EXPECT_NEAR(e.pressure, 1000, 1e-6);
  }
}

/// E = kinetic + gravity + elastic + bumpers changes at the rate that the powers tell.
void expect_power_balance(const std::string& law, const std::string& pairing, const std::string& more_bodies = "") {
  Model model(parse_scene(R"({"laws": {"law": )" + law + R"(},
    "ground": {"surfaces": [{"name": "floor", "make": "plate", "parameters": {"extent_x": 4, "extent_y": 4, "thickness": 2}}]},
    "bodies": [{"name": "block", "mass": 100, "at": {"position": [0.05, 0.02, 0.49]}, "velocity": [0.4, 0.1, -0.3],
      "surfaces": [{"name": "block", "make": "box"}]})" +
                              more_bodies + R"(],
    "pairings": [{"E": "floor", "F": "block", "law": "law", )" +
                              pairing + R"(}], "duration": 1})",
                          "test.json"));
  const Eigen::VectorXd y = model.start();
  Eigen::VectorXd dydt(model.size());
  ASSERT_EQ(model.derivative(0, y, dydt), Evaluation::available);
  const double dt = 1e-6;
  const double before = model.observe(0, y - dt * dydt).energies.total();
  const double after = model.observe(0, y + dt * dydt).energies.total();
  const Powers powers = model.observe(0, y).powers;
  const double taken = powers.damping + powers.friction + powers.joints - powers.motions;
  EXPECT_GT(taken, 1);
  EXPECT_NEAR((after - before) / (2 * dt), -taken, 1e-5 * std::abs(taken));
}

TEST(PowerBalance, OfAFlatContactCloses) {
  const std::string common = R"("damping": 1e4, "friction": 0.3, "slip_velocity": 1e-2, "transition_depth": 0.05})";
  for (const char* pairing : {R"("mode": "E", "scheme": "clipped")", R"("mode": "F")",
                              R"("mode": "F", "scheme": "clipped")", R"("mode": "both", "scheme": "clipped")"}) {
    SCOPED_TRACE(pairing);
    expect_power_balance(R"({"stiffness": 1e6, )" + common, pairing);
    expect_power_balance(R"({"layers": [1.5e6, 3e6], )" + common, pairing);
  }
}

// Two arms in a row with bumpers and dampers, all speeds other than 0; and a turntable at prescribed speed with an arm
// on it.
TEST(PowerBalance, OfJointsBumpersAndPrescribedMotionsCloses) {
  expect_power_balance(R"({"stiffness": 1e6})", R"("mode": "F")", R"(,
    {"name": "turntable", "mass": 5, "inertia": [1, 1, 1], "centre_of_mass": [0.3, 0, 0], "joint": {"type": "pin",
      "prescribed_speed": 2, "in_parent": {"position": [5, 0, 0], "rotation": {"axis": [1, 0, 0], "angle": 0.4}}}},
    {"name": "arm", "mass": 2, "inertia": [1, 2, 1.5, 0.1, 0.2, 0.1], "centre_of_mass": [0.3, 0.2, 0.1], "joint": {"type": "gimbal",
      "parent": "turntable", "in_parent": {"position": [1, 0, 0]}, "coordinates": [0.3, 0.4, 0.5], "speeds": [3, -2, 1],
      "damping": 0.7, "limits": [{"coordinate": 0, "from": -1, "to": 0.2, "stiffness": 40, "dissipation": 0.3},
                                 {"coordinate": 1, "from": 0.6, "to": 1, "stiffness": 30, "dissipation": 0.2}]}},
    {"name": "fore", "mass": 1, "inertia": [1, 1, 1], "centre_of_mass": [0, 0.2, 0], "joint": {"type": "ball",
      "parent": "arm", "in_parent": {"position": [0, 1, 0]}, "damping": 0.2}},
    {"name": "hand", "mass": 1, "inertia": [1, 1, 1], "centre_of_mass": [0, 0.2, 0], "joint": {"type": "universal",
      "parent": "fore", "in_parent": {"position": [0, 1, 0]}, "coordinates": [0.2, 0.6], "speeds": [1, -2], "damping": 0.2}},
    {"name": "floating", "mass": 1, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0], "velocity": [1, 1, 1],
      "joint": {"type": "free", "parent": "turntable", "damping": 0.5}})");
}

}  // namespace
}  // namespace pcm::simulate
