// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/run_identity.h"

#include <array>
#include <bit>
#include <nlohmann/json.hpp>

#include "compare/io/json/question_json.h"
#include "compare/io/names.h"
#include "compare/io/provenance/sha256.h"

namespace pcm::compare {
namespace {

/// What of a kept run's identity is not an argument of the command line.
bool is_argument(const std::string& key) {
  return key != "format" && key != "build" && key != "pairs";
}

/// Equal where poses, velocities and lines are, bit for bit.
std::string bytes_of(const std::vector<RecordedState>& states) {
  std::string bytes;
  const auto add = [&bytes](const auto& number) {
    const auto chars = std::bit_cast<std::array<char, sizeof number>>(number);
    bytes.append(chars.data(), chars.size());
  };
  for (const RecordedState& state : states) {
    for (const double x : state.pose.A.reshaped()) add(x);
    for (const Eigen::Vector3d& vector : {state.pose.r, state.velocity.v, state.velocity.w})
      for (const double x : vector) add(x);
    add(state.line);
  }
  return bytes;
}

}  // namespace

nlohmann::ordered_json identity_of(const VerificationPlan& plan) {
  nlohmann::ordered_json json;
  json["format"] = "pcm verification 7";
  json["build"] = plan.build;
  json["poses"] = plan.poses;
  json["seed"] = plan.seed;
  for (const Mode mode : plan.modes) json["modes"].push_back(std::string(name(mode)));
  for (const Scheme scheme : plan.schemes) json["schemes"].push_back(std::string(name(scheme)));
  for (const Stratum stratum : plan.strata) json["strata"].push_back(std::string(name(stratum)));
  if (plan.law) json["law"] = law_json(*plan.law);
  for (const SurfacePair& pair : plan.pairs) {
    nlohmann::ordered_json surfaces{sha256(pair.E), sha256(pair.F)};
    for (const auto& [mesh_E, mesh_F] : pair.variants) {
      surfaces.push_back(sha256(mesh_E));
      surfaces.push_back(sha256(mesh_F));
    }
    json["pairs"].push_back({{"name", pair.name}, {"surfaces", surfaces}});
  }
  for (std::size_t k = 0; k < plan.recorded.size(); ++k) {
    const RecordedPoses& recorded = plan.recorded[k];
    nlohmann::ordered_json& entry = json["pairs"][k];
    for (const Mode mode : recorded.modes) entry["modes"].push_back(std::string(name(mode)));
    entry["scheme"] = std::string(name(recorded.scheme));
    entry["law"] = law_json(plan.pairs[k].law);
    entry["states"] = sha256(bytes_of(recorded.states));
  }
  return json;
}

nlohmann::ordered_json question_of(const VerificationPlan& plan) {
  nlohmann::ordered_json question = identity_of(plan);
  question.erase("format");
  question.erase("build");
  if (plan.law) {
    question["law"] = law_json(*plan.law, Notation::decimal);
  } else if (plan.recorded.empty()) {
    question["law"] = "drawn for each pose";
  } else {
    question.erase("seed");
    question.erase("strata");
    for (std::size_t k = 0; k < plan.pairs.size(); ++k)
      question["pairs"][k]["law"] = law_json(plan.pairs[k].law, Notation::decimal);
  }
  return question;
}

bool same_arguments(const VerificationPlan& plan, const nlohmann::ordered_json& identity) {
  // What the program and its pairs add is compared apart.
  const nlohmann::ordered_json ours = identity_of(plan);
  if (!identity.is_object()) return false;
  for (const auto& [key, value] : ours.items())
    if (is_argument(key) && (!identity.contains(key) || identity[key] != value)) return false;
  for (const auto& [key, value] : identity.items())
    if (is_argument(key) && !ours.contains(key)) return false;
  return true;
}

std::string difference_from(const VerificationPlan& plan, const nlohmann::ordered_json& identity) {
  if (!identity.contains("build") || identity["build"] != plan.build) return "of another build of pcm";
  if (identity == identity_of(plan)) return "";
  return plan.recorded.empty() ? "on other surfaces" : "of another recording";
}

}  // namespace pcm::compare
