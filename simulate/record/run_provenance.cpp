// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/record/run_provenance.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "compare/io/json/question_json.h"
#include "compare/io/names.h"
#include "compare/io/provenance/sha256.h"

namespace pcm::simulate {

using Json = nlohmann::ordered_json;

namespace {

const char* word(JacobianOf jacobian) {
  return jacobian == JacobianOf::tangents ? "tangents" : "differences";
}

}  // namespace

Json settings_of(const Scene& scene) {
  Json json{{"duration", scene.duration},
            {"method", name(scene.integrator.method)},
            {"relative_tolerance", scene.integrator.relative_tolerance},
            {"absolute_tolerance", scene.integrator.absolute_tolerance},
            {"greatest_step", scene.integrator.greatest_step},
            {"spectrum_interval", scene.output.spectrum_interval}};
  if (takes_jacobians(scene.integrator.method)) json["jacobian"] = word(scene.integrator.jacobian);
  for (const ScenePairing& pairing : scene.pairings) json["slip_velocities"].push_back(pairing.law.slip_velocity);
  if (scene.initial_state) {
    Json y = Json::array();
    for (const double value : scene.initial_state->y) y.push_back(compare::hexadecimal(value));
    json["initial_state"] = {{"t", compare::hexadecimal(scene.initial_state->t)}, {"y", std::move(y)}};
  }
  return json;
}

Json pairing_json(const ScenePairing& pairing) {
  return {{"E", pairing.E},
          {"F", pairing.F},
          {"law", compare::law_json(pairing.law)},
          {"mode", std::string(compare::name(pairing.mode))},
          {"scheme", std::string(compare::name(pairing.scheme))}};
}

namespace {

Json question_of_scene(const std::string& scene_name, const std::string& scene_text, const Scene& scene) {
  Json question{{"scene", scene_name},
                {"scene_sha256", compare::sha256(scene_text)},
                {"pairings", Json::array()},
                {"surfaces", Json::array()}};
  for (const ScenePairing& pairing : scene.pairings) question["pairings"].push_back(pairing_json(pairing));
  for (const SceneSurface& surface : scene.surfaces)
    question["surfaces"].push_back({{"name", surface.name}, {"sha256", compare::sha256(surface.surface.mesh())}});
  return question;
}

/// Each trial's own number, each once, in their order.
template <class Number>
Json each_once(const std::vector<IntegratorTrial>& trials, const Number& number) {
  Json values = Json::array();
  for (const IntegratorTrial& trial : trials) {
    const Json value = number(trial);
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

}  // namespace

Json question_of_run(const std::string& scene_name, const std::string& scene_text, const Scene& scene, bool complete) {
  Json question = question_of_scene(scene_name, scene_text, scene);
  question["settings"] = settings_of(scene);
  question["complete"] = complete;
  return question;
}

Json question_of_comparison(const std::string& scene_name, const std::string& scene_text, const Scene& scene,
                            const IntegratorComparison& comparison) {
  Json question = question_of_scene(scene_name, scene_text, scene);
  question["duration"] = scene.duration;
  question["integrators"] = each_once(comparison.by_tolerance, [](const IntegratorTrial& t) { return t.integrator; });
  question["jacobians"] = each_once(comparison.by_tolerance, [](const IntegratorTrial& t) { return word(t.jacobian); });
  question["tolerances"] = each_once(comparison.by_tolerance, [](const IntegratorTrial& t) { return t.tolerance; });
  question["slip_velocities"] =
      each_once(comparison.by_slip_velocity, [](const IntegratorTrial& t) { return t.slip_velocity; });
  question["reference_tolerance"] = comparison.reference_tolerance;
  return question;
}

compare::ColumnUnits run_column_units(const std::vector<StateColumn>& of_states) {
  compare::ColumnUnits units{{"t", "s"},
                             {"size", "s"},
                             {"kinetic", "J"},
                             {"gravity", "J"},
                             {"elastic", "J"},
                             {"bumpers", "J"},
                             {"lost_to_damping", "J"},
                             {"lost_to_friction", "J"},
                             {"lost_to_joints", "J"},
                             {"brought_by_motions", "J"},
                             {"depth", "m"},
                             {"area", "m^2"},
                             {"normal_force", "N"},
                             {"tangential_force", "N"},
                             {"least_real", "1/s"},
                             {"greatest_imaginary", "1/s"},
                             {"radius", "1/s"}};
  for (const StateColumn& column : of_states) units.push_back({column.name, column.unit});
  return units;
}

}  // namespace pcm::simulate
