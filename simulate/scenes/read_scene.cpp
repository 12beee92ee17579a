// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/scenes/read_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "meshes/generate/make.h"
#include "pcm/bad_input.h"
#include "pcm/check.h"
#include "pcm/engine.h"
#include "pcm/read_mesh.h"
#include "simulate/scenes/check_schema.h"
#include "simulate/scenes/located_json.h"
#include "simulate/scenes/mass_properties.h"
#include "simulate/scenes/still_instants.h"

namespace pcm::simulate {
namespace {

using Json = nlohmann::json;

Eigen::Vector3d vector_from(const Json& json) {
  return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

template <class Enum, std::size_t n>
Enum word_from(const std::string& word, const std::pair<const char*, Enum> (&words)[n]) {
  for (const auto& [name, value] : words)
    if (word == name) return value;
  throw BadInput("the word '" + word + "' is in the schema alone");  // and so in no file that passed it
}

constexpr std::pair<const char*, JointType> kJointTypes[] = {
    {"weld", JointType::weld},     {"pin", JointType::pin},
    {"slider", JointType::slider}, {"universal", JointType::universal},
    {"gimbal", JointType::gimbal}, {"ball", JointType::ball},
    {"free", JointType::free}};
constexpr std::pair<const char*, Method> kMethods[] = {{"adams", Method::adams},
                                                       {"bdf", Method::bdf},
                                                       {"ida", Method::ida},
                                                       {"dormand_prince", Method::dormand_prince},
                                                       {"esdirk", Method::esdirk},
                                                       {"rkc", Method::rkc},
                                                       {"runge_kutta_merson", Method::runge_kutta_merson}};
constexpr std::pair<const char*, JacobianOf> kJacobians[] = {{"differences", JacobianOf::differences},
                                                             {"tangents", JacobianOf::tangents}};
constexpr std::pair<const char*, DampingMode> kDampingModes[] = {{"no_tension", DampingMode::no_tension},
                                                                 {"no-tension", DampingMode::no_tension},
                                                                 {"full", DampingMode::full},
                                                                 {"compression", DampingMode::compression}};
constexpr std::pair<const char*, Mode> kModes[] = {{"E", Mode::E}, {"F", Mode::F}, {"both", Mode::both}};
constexpr std::pair<const char*, Scheme> kSchemes[] = {{"barycentric", Scheme::barycentric},
                                                       {"clipped", Scheme::clipped}};

/// Values of the document by pointer. The schema holds already.
class SceneReader {
 public:
  SceneReader(const LocatedJson& json, std::filesystem::path folder) : json_(json), folder_(std::move(folder)) {}

  Scene read() {
    const Json& root = json_.document();
    scene_.title = root.value("title", "");
    if (root.contains("gravity")) scene_.gravity_G = vector_from(root["gravity"]);
    if (root.contains("laws"))
      for (const auto& [name, law] : root["laws"].items()) laws_[name] = law_from(law, pointer("/laws", name));
    if (root.contains("ground") && root["ground"].contains("surfaces")) read_surfaces(root["ground"], "/ground", -1);
    for (std::size_t i = 0; i < root["bodies"].size(); ++i) read_body(root["bodies"][i], pointer("/bodies", i));
    if (root.contains("pairings"))
      for (std::size_t i = 0; i < root["pairings"].size(); ++i)
        read_pairing(root["pairings"][i], pointer("/pairings", i));
    scene_.duration = root["duration"].get<double>();
    if (root.contains("integrator")) read_integrator(root["integrator"]);
    if (root.contains("output")) read_output(root["output"]);
    return std::move(scene_);
  }

 private:
  static std::string pointer(const std::string& parent, const std::string& key) {
    return parent + Json::json_pointer("").operator/=(key).to_string();
  }
  static std::string pointer(const std::string& parent, std::size_t i) { return parent + "/" + std::to_string(i); }

  static void read(const Json& json, const char* key, double& value) {
    if (json.contains(key)) value = json[key].get<double>();
  }

  Placement placement_from(const Json& json, const std::string& at) const;
  ContactLaw law_from(const Json& json, const std::string& at) const;
  void read_body(const Json& json, const std::string& at);
  void read_surfaces(const Json& owner, const std::string& at, Index body);
  fast::Surface surface_from(const Json& json, const std::string& at) const;
  Joint joint_from(const Json& json, const std::string& at) const;
  MassProperties mass_from(const Json& json, const std::string& at, std::size_t first_surface) const;
  void read_pairing(const Json& json, const std::string& at);
  void read_integrator(const Json& json);
  void read_output(const Json& json);
  void read_stills(const Json& json);

  const LocatedJson& json_;
  std::filesystem::path folder_;
  Scene scene_;
  std::map<std::string, ContactLaw> laws_;
  std::map<std::string, Index> bodies_, surfaces_;
};

Placement SceneReader::placement_from(const Json& json, const std::string& at) const {
  Placement placement;
  if (json.contains("position")) placement.p = vector_from(json["position"]);
  if (json.contains("rotation")) {
    const Eigen::Vector3d axis = vector_from(json["rotation"]["axis"]);
    const double length = axis.stableNorm();
    if (!(length > 0)) json_.refuse(at + "/rotation/axis", "it has no direction");
    placement.R = Eigen::AngleAxisd(json["rotation"]["angle"].get<double>(), axis / length).toRotationMatrix();
  }
  return placement;
}

ContactLaw SceneReader::law_from(const Json& json, const std::string& at) const {
  ContactLaw law;
  read(json, "stiffness", law.stiffness);
  if (json.contains("layers"))
    law.layers = LayerStiffness{json["layers"][0].get<double>(), json["layers"][1].get<double>()};
  if (json.contains("stiffness") == json.contains("layers")) json_.refuse(at, "it takes either stiffness or layers");
  read(json, "damping", law.damping);
  read(json, "transition_depth", law.transition_depth);
  read(json, "friction", law.friction);
  read(json, "slip_velocity", law.slip_velocity);
  read(json, "max_penetration", law.max_penetration);
  if (json.contains("damping_mode"))
    law.damping_mode = word_from(json["damping_mode"].get<std::string>(), kDampingModes);
  return law;
}

fast::Surface SceneReader::surface_from(const Json& json, const std::string& at) const {
  if (json.contains("make") == json.contains("file")) json_.refuse(at, "it takes either make or file");
  if (json.contains("parameters") && !json.contains("make")) json_.refuse(at + "/parameters", "they belong to make");
  const std::string source = at + (json.contains("make") ? "/make" : "/file");
  try {
    TriangleMesh mesh = json.contains("make")
                            ? make(json["make"].get<std::string>(),
                                   json.value("parameters", std::map<std::string, double, std::less<>>()))
                            : read_mesh(folder_ / json["file"].get<std::string>());
    const double scale = json.value("scale", 1.0);
    if (scale != 1)
      for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= scale;
    return fast::Surface(std::move(mesh));  // says what is unfit
  } catch (const BadInput& error) {
    json_.refuse(source, error.what());
  }
}

void SceneReader::read_surfaces(const Json& owner, const std::string& at, Index body) {
  for (std::size_t i = 0; i < owner["surfaces"].size(); ++i) {
    const Json& json = owner["surfaces"][i];
    const std::string here = pointer(at + "/surfaces", i);
    const auto name = json["name"].get<std::string>();
    if (!surfaces_.emplace(name, static_cast<Index>(scene_.surfaces.size())).second)
      json_.refuse(here + "/name", "another surface has the name '" + name + "'");
    const Placement at_B = json.contains("at") ? placement_from(json["at"], here + "/at") : Placement();
    SceneSurface surface{name, body, at_B, surface_from(json, here)};
    if (json.contains("colour"))
      for (std::size_t k = 0; k < 3; ++k) surface.colour[k] = json["colour"][k].get<std::uint8_t>();
    scene_.surfaces.push_back(std::move(surface));
  }
}

Joint SceneReader::joint_from(const Json& json, const std::string& at) const {
  Joint joint;
  joint.type = word_from(json["type"].get<std::string>(), kJointTypes);
  const std::string parent = json.value("parent", "ground");
  if (parent != "ground") {
    const auto found = bodies_.find(parent);
    if (found == bodies_.end())
      json_.refuse(at + "/parent",
                   "no body before this one has the name '" + parent + "'; joints form a tree, without loops");
    joint.parent = found->second;
  }
  if (json.contains("in_parent")) joint.in_parent = placement_from(json["in_parent"], at + "/in_parent");
  if (json.contains("in_body")) joint.in_body = placement_from(json["in_body"], at + "/in_body");
  read(json, "damping", joint.damping);
  if (joint.damping > 0 && joint.type == JointType::weld) json_.refuse(at + "/damping", "a weld has no speed to damp");
  const int count = coordinate_count(joint.type);
  const auto numbers = [&](const char* key, std::vector<double>& values) {
    if (!json.contains(key)) return;
    values = json[key].get<std::vector<double>>();
    if (static_cast<int>(values.size()) != count)
      json_.refuse(at + "/" + key,
                   "this joint has " + std::to_string(count) + " of them, not " + std::to_string(values.size()));
  };
  numbers("coordinates", joint.coordinates);
  numbers("speeds", joint.speeds);
  if (json.contains("limits")) {
    for (std::size_t i = 0; i < json["limits"].size(); ++i) {
      const Json& limit = json["limits"][i];
      const std::string here = pointer(at + "/limits", i);
      // Compared before it is an int, as which 2^32 would be 0.
      if (limit["coordinate"].get<double>() >= count)
        json_.refuse(here + "/coordinate", "this joint has " + std::to_string(count) + " coordinates, numbered from 0");
      Limit read_limit{limit["coordinate"].get<int>(), limit["from"].get<double>(), limit["to"].get<double>(),
                       limit["stiffness"].get<double>(), limit.value("dissipation", 0.0)};
      if (!(read_limit.from < read_limit.to)) json_.refuse(here + "/to", "it must be greater than from");
      joint.limits.push_back(read_limit);
    }
  }
  if (json.contains("prescribed_speed")) {
    if (joint.type != JointType::slider && joint.type != JointType::pin)
      json_.refuse(at + "/prescribed_speed", "only a slider or a pin has one");
    if (!joint.speeds.empty()) json_.refuse(at + "/speeds", "the joint's speed is prescribed");
    if (joint.parent >= 0) json_.refuse(at + "/prescribed_speed", "only a body whose parent is ground has one");
    joint.prescribed_speed = json["prescribed_speed"].get<double>();
  }
  return joint;
}

Eigen::Matrix3d inertia_from(const Json& json) {
  const auto entry = [&json](std::size_t i) { return i < json.size() ? json[i].get<double>() : 0.0; };
  Eigen::Matrix3d inertia;
  inertia << entry(0), entry(3), entry(4), entry(3), entry(1), entry(5), entry(4), entry(5), entry(2);
  return inertia;
}

MassProperties SceneReader::mass_from(const Json& json, const std::string& at, std::size_t first_surface) const {
  if (json.contains("mass") == json.contains("density"))
    json_.refuse(at, "a body takes either mass, in kg, or density, in kg/m^3");
  if (json.contains("density"))
    for (const char* key : {"centre_of_mass", "inertia"})
      if (json.contains(key)) json_.refuse(at + "/" + key, "with density it is that of the solid");
  MassProperties result;
  const bool all_given = json.contains("centre_of_mass") && json.contains("inertia");
  if (!all_given) {
    std::vector<PlacedMesh> closed;
    for (std::size_t s = first_surface; s < scene_.surfaces.size(); ++s)
      if (scene_.surfaces[s].surface.closed())
        closed.push_back({&scene_.surfaces[s].surface.mesh(), scene_.surfaces[s].at_B});
    try {
      result = solid_of_density_1(closed);
    } catch (const BadInput&) {
      json_.refuse(at, "give its inertia and centre_of_mass: it has no closed surface that they could be taken from");
    }
  }
  const double density = json.contains("density") ? json["density"].get<double>()
                                                  : (all_given ? 0 : json["mass"].get<double>() / result.mass);
  result.inertia_B *= density;
  result.mass = json.contains("mass") ? json["mass"].get<double>() : density * result.mass;
  if (json.contains("centre_of_mass")) result.centre_B = vector_from(json["centre_of_mass"]);
  if (json.contains("inertia")) {
    if (json["inertia"].size() != 3 && json["inertia"].size() != 6)
      json_.refuse(at + "/inertia", "it takes 3 or 6 numbers");
    result.inertia_B = inertia_from(json["inertia"]);
    const std::string flaw = flaw_of_inertia(result.inertia_B);
    if (!flaw.empty()) json_.refuse(at + "/inertia", flaw);
  }
  const std::string flaw = flaw_of_mass(result);
  if (!flaw.empty()) json_.refuse(at, flaw);
  return result;
}

void SceneReader::read_body(const Json& json, const std::string& at) {
  Body body;
  body.name = json["name"].get<std::string>();
  if (body.name == "ground")
    json_.refuse(at + "/name", "'ground' is what stands still; its surfaces are under the key ground");
  if (json.contains("joint")) body.joint = joint_from(json["joint"], at + "/joint");
  const auto index = static_cast<Index>(scene_.bodies.size());
  if (!bodies_.emplace(body.name, index).second)
    json_.refuse(at + "/name", "another body has the name '" + body.name + "'");
  const std::size_t first_surface = scene_.surfaces.size();
  if (json.contains("surfaces")) read_surfaces(json, at, index);
  body.mass = mass_from(json, at, first_surface);
  if (body.joint.type != JointType::free)
    for (const char* key : {"at", "velocity", "angular_velocity"})
      if (json.contains(key))
        json_.refuse(at + "/" + key, "only a body with a free joint has it; others have coordinates and speeds");
  if (json.contains("at")) body.at_G = placement_from(json["at"], at + "/at");
  if (json.contains("velocity")) body.velocity_G = vector_from(json["velocity"]);
  if (json.contains("angular_velocity")) body.angular_velocity_G = vector_from(json["angular_velocity"]);
  scene_.bodies.push_back(std::move(body));
}

void SceneReader::read_pairing(const Json& json, const std::string& at) {
  ScenePairing pairing;
  const auto surface = [&](const char* key) {
    const auto found = surfaces_.find(json[key].get<std::string>());
    if (found == surfaces_.end())
      json_.refuse(at + "/" + key, "there is no surface '" + json[key].get<std::string>() + "'");
    return found->second;
  };
  pairing.E = surface("E");
  pairing.F = surface("F");
  const auto body_of = [this](Index s) { return scene_.surfaces[static_cast<std::size_t>(s)].body; };
  if (body_of(pairing.E) == body_of(pairing.F)) json_.refuse(at + "/F", "both surfaces are on the same body");
  for (const ScenePairing& other : scene_.pairings)
    if (std::minmax(other.E, other.F) == std::minmax(pairing.E, pairing.F))
      json_.refuse(at, "these two surfaces have a pairing already; their force would count twice");
  const auto law = laws_.find(json["law"].get<std::string>());
  if (law == laws_.end()) json_.refuse(at + "/law", "there is no law '" + json["law"].get<std::string>() + "'");
  pairing.law = law->second;
  if (json.contains("mode")) pairing.mode = word_from(json["mode"].get<std::string>(), kModes);
  if (json.contains("scheme")) pairing.scheme = word_from(json["scheme"].get<std::string>(), kSchemes);
  scene_.pairings.push_back(pairing);
}

void SceneReader::read_integrator(const Json& json) {
  IntegratorSettings& settings = scene_.integrator;
  if (json.contains("method")) settings.method = word_from(json["method"].get<std::string>(), kMethods);
  if (json.contains("jacobian")) {
    settings.jacobian = word_from(json["jacobian"].get<std::string>(), kJacobians);
    if (!takes_jacobians(settings.method))
      json_.refuse("/integrator/jacobian", json["method"].get<std::string>() + kTakesNoJacobians);
  }
  read(json, "relative_tolerance", settings.relative_tolerance);
  read(json, "absolute_tolerance", settings.absolute_tolerance);
  read(json, "greatest_step", settings.greatest_step);
  if (settings.greatest_step < scene_.duration / kMostSteps)
    json_.refuse("/integrator/greatest_step", "the scene would take more than 1e9 steps");
}

void SceneReader::read_output(const Json& json) {
  read(json, "interval", scene_.output.interval);
  read(json, "checkpoint_interval", scene_.output.checkpoint_interval);
  for (const char* key : {"interval", "checkpoint_interval"})
    if (json.value(key, scene_.duration) < scene_.duration / kMostRecords)
      json_.refuse(pointer("/output", key), "it is less than a millionth of the duration");
  scene_.output.spectrum_interval = json.value("spectrum_interval", std::int64_t{0});
  if (json.contains("follow")) {
    const auto found = surfaces_.find(json["follow"].get<std::string>());
    if (found == surfaces_.end())
      json_.refuse("/output/follow", "there is no surface '" + json["follow"].get<std::string>() + "'");
    scene_.output.follow = found->second;
  }
  if (json.contains("stills")) read_stills(json["stills"]);
}

void SceneReader::read_stills(const Json& json) {
  std::vector<double>& stills = scene_.output.stills;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const double t = json[i].get<double>();
    const std::string flaw = flaw_of_instant(t, stills, scene_.duration);
    if (!flaw.empty()) json_.refuse(pointer("/output/stills", i), flaw);
    stills.push_back(t);
  }
}

}  // namespace

std::vector<std::pair<std::string, Method>> known_methods() {
  return {std::begin(kMethods), std::end(kMethods)};
}

Method method_named(const std::string& word) {
  std::string known;
  for (const auto& [name, method] : kMethods) {
    if (word == name) return method;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  throw BadInput("there is no integrator '" + word + "'; known: " + known);
}

JacobianOf jacobian_named(const std::string& word) {
  for (const auto& [name, jacobian] : kJacobians)
    if (word == name) return jacobian;
  throw BadInput("there are no Jacobians of '" + word + "'; known: differences, tangents");
}

Scene parse_scene(const std::string& text, const std::filesystem::path& file) {
  const LocatedJson json(file.string(), text);
  check_schema(json, scene_schema());
  return SceneReader(json, file.parent_path()).read();
}

}  // namespace pcm::simulate
