// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Names of a state's components, held against what the components do.
#include "simulate/model/state_columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "simulate/model/model.h"
#include "simulate/scenes/read_scene.h"

namespace pcm::simulate {
namespace {

std::string body(const std::string& name, const std::string& joint, const std::string& parent) {
  return R"({"name": ")" + name + R"(", "mass": 1, "inertia": [1, 1.2, 1.1], "centre_of_mass": [0, 0, 0],
             "joint": {"type": ")" +
         joint + R"(", "parent": ")" + parent + "\"}}";
}

/// Two trees, listed so that their bodies alternate.
Model every_joint() {
  return Model(parse_scene(R"({"duration": 1, "bodies": [)" + body("ball", "ball", "ground") + ", " +
                               body("arm", "pin", "ground") + ", " + body("free", "free", "ball") + ", " +
                               body("welded", "weld", "arm") + ", " + body("sledge", "slider", "welded") + ", " +
                               body("cross", "universal", "ball") + ", " +
                               body("head, \\\"mine\\\"", "gimbal", "sledge") + "]}",
                           "test.json"));
}

std::vector<std::string> names(const Model& model) {
  std::vector<std::string> all;
  for (const StateColumn& column : model.columns()) all.push_back(column.name);
  return all;
}

Eigen::Index place(const std::vector<std::string>& all, const std::string& name) {
  const auto found = std::find(all.begin(), all.end(), name);
  EXPECT_NE(found, all.end()) << name;
  return found - all.begin();
}

TEST(StateColumns, HaveANameAndAUnitForEveryComponentAndNoNameTwice) {
  const Model model = every_joint();
  std::vector<std::string> all = names(model);
  EXPECT_EQ(all.size(), 4U + 1 + 7 + 1 + 2 + 3 + 3 + 1 + 6 + 1 + 2 + 3);
  for (const StateColumn& column : model.columns()) {
    EXPECT_FALSE(column.name.empty());
    EXPECT_FALSE(column.unit.empty());
    EXPECT_EQ(column.name.find_first_of(",\"\n"), std::string::npos) << column.name;
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
}

TEST(StateColumns, OfSpeedsChangeTheCoordinatesOfTheSameName) {
  struct Case {
    std::string speed, coordinate, unit;
    double rate;  ///< of the coordinate, at a speed of 1
  };
  Model model = every_joint();
  const std::vector<std::string> all = names(model);
  for (const auto& [speed, coordinate, unit, rate] :
       std::vector<Case>{{"ball.omega_x", "ball.quaternion_x", "1", 0.5},
                         {"ball.omega_z", "ball.quaternion_z", "1", 0.5},
                         {"arm.rate", "arm.angle", "rad", 1},
                         {"free.omega_y", "free.quaternion_y", "1", 0.5},
                         {"free.v_x", "free.x", "m", 1},
                         {"free.v_z", "free.z", "m", 1},
                         {"sledge.speed", "sledge.displacement", "m", 1},
                         {"cross.rate_x", "cross.angle_x", "rad", 1},
                         {"cross.rate_y", "cross.angle_y", "rad", 1},
                         {"head_ _mine_.rate_x", "head_ _mine_.angle_x", "rad", 1},
                         {"head_ _mine_.rate_z", "head_ _mine_.angle_z", "rad", 1}}) {
    SCOPED_TRACE(speed);
    Eigen::VectorXd y = model.start(), dydt(model.size());
    y.tail(model.size() - place(all, "ball.omega_x")).setZero();
    y[place(all, speed)] = 1;
    ASSERT_EQ(model.derivative(0, y, dydt), Evaluation::available);
    for (Eigen::Index i = 0; i < place(all, "ball.omega_x"); ++i)
      EXPECT_EQ(dydt[i], i == place(all, coordinate) ? rate : 0) << all[static_cast<std::size_t>(i)];
    EXPECT_EQ(model.columns()[static_cast<std::size_t>(place(all, coordinate))].unit, unit);
    EXPECT_EQ(model.columns()[static_cast<std::size_t>(place(all, speed))].unit, unit == "m" ? "m/s" : "rad/s");
  }
}

}  // namespace
}  // namespace pcm::simulate
