// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Names of a state's components, held against where the components put bodies.
#include "simulate/model/state_columns.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "simulate/model/model.h"
#include "simulate/scenes/read_scene.h"

namespace pcm::simulate {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

const Vector3d kAlongX = Vector3d::UnitX(), kAlongY = Vector3d::UnitY(), kAlongZ = Vector3d::UnitZ();

std::string body(const std::string& name, const std::string& joint, const std::string& parent) {
  return R"({"name": ")" + name + R"(", "mass": 1, "inertia": [1, 1.2, 1.1], "centre_of_mass": [0, 0, 0],
             "surfaces": [{"name": ")" +
         name + R"(", "make": "box"}], "joint": {"type": ")" + joint + R"(", "parent": ")" + parent + "\"}}";
}

Model model_with(const std::string& bodies) {
  return Model(parse_scene(R"({"duration": 1, "bodies": [)" + bodies + "]}", "test.json"));
}

std::vector<std::string> names(const Model& model) {
  std::vector<std::string> all;
  for (const StateColumn& column : model.columns()) all.push_back(column.name);
  return all;
}

using Names = std::vector<std::string>;

// Two trees, listed so that their bodies alternate.
TEST(StateColumns, AreTheCoordinatesOfAllBodiesAndThenTheirSpeeds) {
  const Model model = model_with(body("ball", "ball", "ground") + ", " + body("arm", "pin", "ground") + ", " +
                                 body("free", "free", "ball") + ", " + body("welded", "weld", "arm") + ", " +
                                 body("sledge", "slider", "welded") + ", " + body("cross", "universal", "ball") + ", " +
                                 body("head", "gimbal", "sledge"));
  EXPECT_EQ(names(model), (Names{"ball.quaternion_w",
                                 "ball.quaternion_x",
                                 "ball.quaternion_y",
                                 "ball.quaternion_z",
                                 "arm.angle",
                                 "free.quaternion_w",
                                 "free.quaternion_x",
                                 "free.quaternion_y",
                                 "free.quaternion_z",
                                 "free.x",
                                 "free.y",
                                 "free.z",
                                 "sledge.displacement",
                                 "cross.angle_x",
                                 "cross.angle_y",
                                 "head.angle_x",
                                 "head.angle_y",
                                 "head.angle_z",
                                 "ball.omega_x",
                                 "ball.omega_y",
                                 "ball.omega_z",
                                 "arm.rate",
                                 "free.omega_x",
                                 "free.omega_y",
                                 "free.omega_z",
                                 "free.v_x",
                                 "free.v_y",
                                 "free.v_z",
                                 "sledge.speed",
                                 "cross.rate_x",
                                 "cross.rate_y",
                                 "head.rate_x",
                                 "head.rate_y",
                                 "head.rate_z"}));
}

TEST(StateColumns, HaveNamesThatTablesHoldAndThatStayDifferent) {
  const Model model =
      model_with(body("a,b", "pin", "ground") + ", " + body("a\\\"b", "pin", "ground") + ", " +
                 body("50%\\n\\u2028", "slider", "ground") + ", " + body("\u00e4 b", "slider", "ground"));
  EXPECT_EQ(names(model),
            (Names{"a%2Cb.angle", "a%22b.angle", "50%25%0A%E2%80%A8.displacement", "\u00e4 b.displacement",
                   "a%2Cb.rate", "a%22b.rate", "50%25%0A%E2%80%A8.speed", "\u00e4 b.speed"}));
}

/// One joint on the ground, with a component of its state set.
class OneJoint {
 public:
  OneJoint(const std::string& joint, const std::string& column, double value)
      : model_(model_with(body("b", joint, "ground"))) {
    y_ = model_.start();
    const std::vector<std::string> all = names(model_);
    const auto found = std::find(all.begin(), all.end(), "b." + column);
    if (found == all.end()) throw std::logic_error("no column " + column);
    place_ = found - all.begin();
    y_[place_] = value;
  }
  Pose pose() { return model_.observe(0, y_).surfaces_G[0]; }
  std::string unit() const { return model_.columns()[static_cast<std::size_t>(place_)].unit; }
  /// Moved on by a second at its speeds.
  void advance() {
    Eigen::VectorXd dydt(y_.size());
    EXPECT_EQ(model_.derivative(0, y_, dydt), Evaluation::available);
    y_ += dydt;
  }

 private:
  Model model_;
  Eigen::VectorXd y_;
  Eigen::Index place_ = 0;
};

TEST(StateColumns, OfCoordinatesMoveTheBodyAsTheirNamesSay) {
  struct Turn {
    std::string joint, column;
    Vector3d axis;
  };
  for (const auto& [joint, column, axis] :
       {Turn{"pin", "angle", kAlongZ}, Turn{"universal", "angle_x", kAlongX}, Turn{"universal", "angle_y", kAlongY},
        Turn{"gimbal", "angle_x", kAlongX}, Turn{"gimbal", "angle_y", kAlongY}, Turn{"gimbal", "angle_z", kAlongZ}}) {
    SCOPED_TRACE(joint + " " + column);
    OneJoint one(joint, column, 0.3);
    EXPECT_LT((one.pose().A - AngleAxisd(0.3, axis).matrix()).norm(), 1e-15);
    EXPECT_EQ(one.unit(), "rad");
  }
  struct Shift {
    std::string joint, column;
    Vector3d way;
  };
  for (const auto& [joint, column, way] : {Shift{"slider", "displacement", kAlongX}, Shift{"free", "x", kAlongX},
                                           Shift{"free", "y", kAlongY}, Shift{"free", "z", kAlongZ}}) {
    SCOPED_TRACE(joint + " " + column);
    OneJoint one(joint, column, 0.5);
    EXPECT_EQ(one.pose().r, 0.5 * way);
    EXPECT_EQ(one.unit(), "m");
  }
}

// A quaternion (1, s n) is a turn by 2 atan s about n.
TEST(StateColumns, OfQuaternionsTurnTheBodyAsTheirNamesSay) {
  for (const char* joint : {"ball", "free"})
    for (const auto& [column, axis] :
         {std::pair("quaternion_x", kAlongX), std::pair("quaternion_y", kAlongY), std::pair("quaternion_z", kAlongZ)}) {
      SCOPED_TRACE(std::string(joint) + " " + column);
      OneJoint one(joint, column, 0.25);
      EXPECT_LT((one.pose().A - AngleAxisd(2 * std::atan(0.25), axis).matrix()).norm(), 1e-15);
      EXPECT_EQ(one.unit(), "1");
      OneJoint nothing(joint, "quaternion_w", 0.5);
      EXPECT_LT((nothing.pose().A - Eigen::Matrix3d::Identity()).norm(), 1e-15);
    }
}

TEST(StateColumns, OfSpeedsMoveTheBodyAsTheirNamesSay) {
  struct Case {
    std::string joint, column, unit;
    Vector3d axis, way;
  };
  const Vector3d none = Vector3d::Zero();
  for (const auto& [joint, column, unit, axis, way] :
       {Case{"pin", "rate", "rad/s", kAlongZ, none}, Case{"universal", "rate_x", "rad/s", kAlongX, none},
        Case{"universal", "rate_y", "rad/s", kAlongY, none}, Case{"gimbal", "rate_x", "rad/s", kAlongX, none},
        Case{"gimbal", "rate_y", "rad/s", kAlongY, none}, Case{"gimbal", "rate_z", "rad/s", kAlongZ, none},
        Case{"ball", "omega_x", "rad/s", kAlongX, none}, Case{"ball", "omega_y", "rad/s", kAlongY, none},
        Case{"ball", "omega_z", "rad/s", kAlongZ, none}, Case{"free", "omega_x", "rad/s", kAlongX, none},
        Case{"free", "omega_y", "rad/s", kAlongY, none}, Case{"free", "omega_z", "rad/s", kAlongZ, none},
        Case{"slider", "speed", "m/s", none, kAlongX}, Case{"free", "v_x", "m/s", none, kAlongX},
        Case{"free", "v_y", "m/s", none, kAlongY}, Case{"free", "v_z", "m/s", none, kAlongZ}}) {
    SCOPED_TRACE(joint + " " + column);
    OneJoint one(joint, column, 0x1p-20);
    EXPECT_EQ(one.unit(), unit);
    one.advance();  // gravity's second lies in the speeds, not yet in the place
    const Pose pose = one.pose();
    const AngleAxisd turn(pose.A);
    EXPECT_LT((turn.angle() * turn.axis() - 0x1p-20 * axis).norm(), 0x1p-40);
    EXPECT_LT((pose.r - 0x1p-20 * way).norm(), 0x1p-40);
  }
}

}  // namespace
}  // namespace pcm::simulate
