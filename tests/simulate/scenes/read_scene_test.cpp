// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/read_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/meshes/expect_bad_input.h"

namespace pcm::simulate {
namespace {

/// A ball on a plate; line numbers matter below.
const std::string kScene = R"({
  "laws": {"soft": {"stiffness": 1e6}},
  "ground": {"surfaces": [{"name": "plate", "make": "plate"}]},
  "bodies": [
    {
      "name": "block", "mass": 3,
      "at": {"position": [0, 0, 1]},
      "velocity": [0, 0, -2],
      "surfaces": [{"name": "block", "make": "box"}]
    },
    {
      "name": "arm", "mass": 1, "inertia": [1, 1, 1], "centre_of_mass": [0, 0, 0.5],
      "joint": {"type": "pin", "parent": "block", "in_parent": {"rotation": {"axis": [0, 2, 0], "angle": 0.5}},
                "coordinates": [0.1], "limits": [{"coordinate": 0, "from": -1, "to": 1, "stiffness": 5}]}
    }
  ],
  "pairings": [{"E": "plate", "F": "block", "law": "soft", "mode": "F", "scheme": "clipped"}],
  "duration": 2,
  "integrator": {"method": "ida", "jacobian": "tangents", "relative_tolerance": 1e-6},
  "output": {"stills": [0, 1.5, 2]}
})";

std::string with(const std::string& what, const std::string& instead) {
  std::string text = kScene;
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), instead);
}

/// Says of each property below `node` that has no description, neither here nor where it is defined.
void expect_descriptions(const nlohmann::json& schema, const nlohmann::json& node) {
  if (!node.is_object()) return;
  const nlohmann::json properties = node.value("properties", nlohmann::json::object());
  for (const auto& [key, property] : properties.items()) {
    const std::string reference = property.value("$ref", "");
    const bool is_described =
        property.contains("description") ||
        (!reference.empty() && schema.at(nlohmann::json::json_pointer(reference.substr(1))).contains("description"));
    EXPECT_TRUE(is_described) << key << ": " << property;
  }
  for (const auto& [key, value] : node.items()) expect_descriptions(schema, value);
}

TEST(SceneSchema, SaysOfEveryKeyWhatItMeans) {
  const nlohmann::json schema = nlohmann::json::parse(scene_schema());
  ASSERT_TRUE(schema.at("definitions").contains("law"));
  expect_descriptions(schema, schema);
}

TEST(ReadScene, TakesEveryKeyToItsPlace) {
  const Scene scene = parse_scene(kScene, "block.json");
  ASSERT_EQ(scene.bodies.size(), 2U);
  EXPECT_EQ(scene.bodies[0].at_G.p.z(), 1);
  EXPECT_EQ(scene.bodies[0].velocity_G.z(), -2);
  EXPECT_EQ(scene.bodies[0].mass.mass, 3);
  const Joint& joint = scene.bodies[1].joint;
  EXPECT_EQ(joint.type, JointType::pin);
  EXPECT_EQ(joint.parent, 0);
  EXPECT_NEAR(joint.in_parent.R(0, 2), std::sin(0.5), 1e-15);
  EXPECT_EQ(joint.coordinates, std::vector<double>{0.1});
  ASSERT_EQ(joint.limits.size(), 1U);
  EXPECT_EQ(joint.limits[0].from, -1);
  EXPECT_EQ(scene.bodies[1].mass.centre_B.z(), 0.5);
  ASSERT_EQ(scene.surfaces.size(), 2U);
  EXPECT_EQ(scene.surfaces[0].body, -1);
  EXPECT_EQ(scene.surfaces[1].body, 0);
  ASSERT_EQ(scene.pairings.size(), 1U);
  EXPECT_EQ(scene.pairings[0].mode, Mode::F);
  EXPECT_EQ(scene.pairings[0].scheme, Scheme::clipped);
  EXPECT_EQ(scene.pairings[0].law.stiffness, 1e6);
  EXPECT_EQ(scene.integrator.method, Method::ida);
  EXPECT_EQ(scene.integrator.jacobian, JacobianOf::tangents);
  EXPECT_EQ(scene.integrator.relative_tolerance, 1e-6);
  EXPECT_EQ(scene.output.stills, (std::vector<double>{0, 1.5, 2}));
  EXPECT_EQ(scene.gravity_G.z(), -9.81);
}

struct BadScene {
  std::string what, instead, message;
};

TEST(ReadScene, TakesIntegersOfAnySize) {
  for (const char* mass :
       {"9223372036854775807", "9223372036854775808", "18446744073709551615", "18446744073709551616"})
    EXPECT_EQ(parse_scene(with("\"mass\": 3", std::string("\"mass\": ") + mass), "block.json").bodies[0].mass.mass,
              std::stod(mass));
}

TEST(ReadScene, RefusesWithFileLineAndKey) {
  const std::vector<BadScene> scenes{
      {R"("duration": 2)", R"("duration": 0)", "block.json:18: duration: Expected number greater than 0"},
      {R"("duration": 2,)", "", "block.json:1: the key 'duration' is missing"},
      {R"("mass": 3,)", R"("mas": 3,)", "block.json:5: bodies[0]: unknown key 'mas'"},
      {R"("mass": 3,)", "", "block.json:5: bodies[0]: a body takes either mass, in kg, or density, in kg/m^3"},
      {R"("mass": 3,)", R"("mass": 3, "density": 2,)", "block.json:5: bodies[0]: a body takes either"},
      {R"("mass": 3,)", R"("mass": "3",)", "block.json:6: bodies[0].mass: a value of this type is not allowed here"},
      {R"("mass": 3,)", R"("mass": -3,)", "block.json:6: bodies[0].mass: Expected number greater than 0"},
      {R"("mass": 3,)", R"("mass": 5e-324,)", "block.json:5: bodies[0]: its mass, its inertia about B's origin or"},
      {R"("mass": 1, "inertia")", R"("mass": 1e-310, "inertia")", "block.json:11: bodies[1]: its mass, its inertia"},
      {"[0, 0, 0.5]", "[0, 0, 5e160]", "block.json:11: bodies[1]: its mass, its inertia about B's origin or"},
      {R"("mass": 3,)", R"("mass": 3, "mass": 3,)", "block.json:6: the key 'mass' is there twice"},
      {R"("mass": 3,)", R"("mass": 3,,)", "block.json:6: no JSON: "},
      {R"("mass": 3,)", "\"mass\": " + std::string(100000, '[') + ",",
       "block.json:6: lists and objects lie in one another more than 64 levels deep"},
      {R"("name": "arm")", R"("name": "block")", "block.json:12: bodies[1].name: another body has the name 'block'"},
      {R"("name": "arm")", R"("name": "ground")", "block.json:12: bodies[1].name: 'ground' is what stands still"},
      {R"("inertia": [1, 1, 1], )", "",
       "block.json:11: bodies[1]: give its inertia and centre_of_mass: it has no closed surface"},
      {"[1, 1, 1]", "[1, 1, 3]", "block.json:12: bodies[1].inertia: a principal moment of inertia exceeds"},
      {"[1, 1, 1]", "[1, 1, 0]", "block.json:12: bodies[1].inertia: a principal moment of inertia is not positive"},
      {"[1, 1, 1]", "[1, 1, 1, 0]", "block.json:12: bodies[1].inertia: it takes 3 or 6 numbers"},
      {R"("type": "pin")", R"("type": "hinge")",
       "block.json:13: bodies[1].joint.type: it must be one of: ball, free, gimbal, pin, slider, universal, weld"},
      {R"("type": "pin")", R"("type": "weld", "damping": 2)",
       "block.json:13: bodies[1].joint.damping: a weld has no speed to damp"},
      {R"("parent": "block")", R"("parent": "leg")", "block.json:13: bodies[1].joint.parent: no body before this one"},
      {"[0, 2, 0]", "[0, 0, 0]", "block.json:13: bodies[1].joint.in_parent.rotation.axis: it has no direction"},
      {"[0.1]", "[0.1, 0.2]", "block.json:14: bodies[1].joint.coordinates: this joint has 1 of them, not 2"},
      {R"("from": -1)", R"("from": 1)", "block.json:14: bodies[1].joint.limits[0].to: it must be greater than from"},
      {R"("coordinate": 0)", R"("coordinate": 1)", "block.json:14: bodies[1].joint.limits[0].coordinate"},
      {R"("law": "soft")", R"("law": "hard")", "block.json:17: pairings[0].law: there is no law 'hard'"},
      {R"("F": "block")", R"("F": "wall")", "block.json:17: pairings[0].F: there is no surface 'wall'"},
      {R"("F": "block")", R"("F": "plate")", "block.json:17: pairings[0].F: both surfaces are on the same body"},
      {R"("scheme": "clipped"})", R"("scheme": "clipped"}, {"E": "block", "F": "plate", "law": "soft"})",
       "block.json:17: pairings[1]: these two surfaces have a pairing already"},
      {R"({"stiffness": 1e6})", "{}", "block.json:2: laws.soft: it takes either stiffness or layers"},
      {R"("make": "box")", R"("make": "boks")", "block.json:9: bodies[0].surfaces[0].make: "},
      {R"("make": "box")", R"("file": "there_is_none.obj")", "block.json:9: bodies[0].surfaces[0].file: "},
      {R"("make": "box")", R"("scale": 2)", "block.json:9: bodies[0].surfaces[0]: it takes either make or file"},
      {R"("name": "plate")", R"("name": "block")", "another surface has the name 'block'"},
      {R"("method": "ida")", R"("method": "euler")", "block.json:19: integrator.method: it must be one of: adams, bdf"},
      {R"("method": "ida")", R"("method": "rkc")", "block.json:19: integrator.jacobian: rkc takes none"},
      {R"("tangents")", R"("exact")", "block.json:19: integrator.jacobian: it must be one of: differences, tangents"},
      {"1e-6", "-1e-6", "block.json:19: integrator.relative_tolerance: Expected number greater than 0"},
      {"1e-6", "1e999", "block.json:19: no JSON: "},
      {R"("coordinate": 0)", R"("coordinate": 4294967296)",
       "block.json:14: bodies[1].joint.limits[0].coordinate: this joint has 1"},
      {R"("coordinates": [0.1],)", R"("speeds": [2], "prescribed_speed": 1,)",
       "block.json:14: bodies[1].joint.speeds: the joint's speed is prescribed"},
      {R"("duration": 2,)", R"("duration": 2, "": 1, "": 2,)", "block.json:18: the key '' is there twice"},
      {"1e-6", R"(1e-6, "greatest_step": 1e-300)", "block.json:19: integrator.greatest_step: the scene would take"},
      {R"("stills": [0, 1.5, 2])", R"("interval": 1e-9)",
       "block.json:20: output.interval: it is less than a millionth of the duration"},
      {R"("stills": [0, 1.5, 2])", R"("checkpoint_interval": 1e-9)",
       "block.json:20: output.checkpoint_interval: it is less than a millionth of the duration"},
      {"[0, 1.5, 2]", "[0, 2.5]", "block.json:20: output.stills[1]: 2.5 s is beyond the end of the scene, 2 s"},
      {"[0, 1.5, 2]", "[0, 1.5, 15e-1]", "block.json:20: output.stills[2]: 1.5 s is there twice"},
      {"[0, 1.5, 2]", "[0, -1]", "block.json:20: output.stills[1]: Expected number greater than or equal to 0"},
      {"[0, 1.5, 2]", "[\"soon\"]", "block.json:20: output.stills[0]: a value of this type is not allowed here"},
      {"[0, 1.5, 2]", "1.5", "block.json:20: output.stills: a value of this type is not allowed here"},
      {"[0, 1.5, 2]", "[nan]", "block.json:20: no JSON: "},
      {R"("velocity": [0, 0, -2])", R"("velocity": [0, 0])", "block.json:8: bodies[0].velocity: "},
  };
  for (const BadScene& bad : scenes) {
    SCOPED_TRACE(bad.what + " -> " + bad.instead);
    expect_bad_input([&] { parse_scene(with(bad.what, bad.instead), "block.json"); }, bad.message);
  }
}

TEST(ReadScene, RefusesStartingVelocitiesOfJointsThatHaveNone) {
  expect_bad_input(
      [] { parse_scene(with(R"("name": "arm",)", R"("name": "arm", "velocity": [1, 0, 0],)"), "block.json"); },
      "bodies[1].velocity: only a body with a free joint has it");
}

TEST(ReadScene, BuiltInScenesAreFit) {
  for (const BuiltInScene& scene : built_in_scenes()) {
    SCOPED_TRACE(scene.name);
    EXPECT_GT(parse_scene(std::string(scene.text), scene.name).pairings.size(), 0U);
  }
}

}  // namespace
}  // namespace pcm::simulate
