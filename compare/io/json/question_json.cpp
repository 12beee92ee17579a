// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/json/question_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "compare/io/json/strict_json.h"
#include "compare/io/names.h"
#include "meshes/files/parse_number.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

constexpr std::array kSchemes = {Scheme::barycentric, Scheme::clipped};
constexpr std::array kModes = {Mode::E, Mode::F, Mode::both};
constexpr std::array kDampingModes = {DampingMode::no_tension, DampingMode::full, DampingMode::compression};

/// The one of the values that goes by that name, with hyphens or, as in Python, underscores.
template <class Value, std::size_t N>
Value named(const Json& json, const std::array<Value, N>& values) {
  const auto word = json.get<std::string>();
  std::string hyphened = word, known;
  std::replace(hyphened.begin(), hyphened.end(), '_', '-');
  for (const Value value : values) {
    if (hyphened == name(value)) return value;
    known += (known.empty() ? "" : ", ") + std::string(name(value));
  }
  throw BadInput(in_quotes(word) + " is none of " + known);
}

void require_list(const Json& json, std::size_t size) {
  if (!json.is_array())
    throw BadInput(fmt::format("a list of {} numbers is wanted; this is of type {}", size, json.type_name()));
  if (json.size() != size) throw BadInput(fmt::format("a list of {} numbers is wanted, not of {}", size, json.size()));
}

}  // namespace

std::string hexadecimal(double x) {
  return fmt::format("{:a}", x);
}

double number_from(const Json& json) {
  // A list or an object may be nested deeper than can be printed.
  if (json.is_structured())
    throw BadInput(std::string("a number in quotes is wanted; this is of type ") + json.type_name());
  if (!json.is_string()) throw BadInput(json.dump() + " is no number in quotes, such as \"0x1.8p-3\"");
  const auto word = json.get<std::string>();
  if (word == "inf") return std::numeric_limits<double>::infinity();
  const std::optional<double> value = parse_number(word);
  if (!value) throw BadInput(in_quotes(word) + " is no number");
  return *value;
}

Eigen::Vector3d vector_from(const Json& json) {
  require_list(json, 3);
  return {number_from(json.at(0)), number_from(json.at(1)), number_from(json.at(2))};
}

Json matrix_json(const Eigen::Matrix3d& A) {
  Json rows = Json::array();
  for (int k = 0; k < 9; ++k) rows.push_back(hexadecimal(A(k / 3, k % 3)));
  return rows;
}

Eigen::Matrix3d matrix_from(const Json& json) {
  require_list(json, 9);
  Eigen::Matrix3d A;
  for (int k = 0; k < 9; ++k) A(k / 3, k % 3) = number_from(json.at(static_cast<std::size_t>(k)));
  return A;
}

Json number_json(double x, Notation notation) {
  return notation == Notation::decimal && std::isfinite(x) ? Json(x) : Json(hexadecimal(x));
}

Json vector_json(const Eigen::Vector3d& x, Notation notation) {
  return Json::array({number_json(x.x(), notation), number_json(x.y(), notation), number_json(x.z(), notation)});
}

double number_in_either_notation(const Json& json) {
  if (!json.is_number()) return number_from(json);
  const auto value = json.get<double>();
  if (!std::isfinite(value)) throw BadInput(json.dump() + " is beyond the range of doubles");
  return value;
}

Json law_json(const ContactLaw& law, Notation notation) {
  const auto number = [notation](double x) { return number_json(x, notation); };
  Json json;
  json["stiffness"] = number(law.stiffness);
  if (law.layers) {
    json["stiffness_E"] = number(law.layers->c_E);
    json["stiffness_F"] = number(law.layers->c_F);
  }
  json["damping"] = number(law.damping);
  json["transition_depth"] = number(law.transition_depth);
  json["friction"] = number(law.friction);
  json["slip_velocity"] = number(law.slip_velocity);
  json["max_penetration"] = number(law.max_penetration);
  json["damping_mode"] = std::string(name(law.damping_mode));
  return json;
}

ContactLaw law_from(const Json& json, double (*number)(const Json&)) {
  const auto number_at = [&](const char* key) { return read_at(json, key, number); };
  ContactLaw law;
  law.stiffness = number_at("stiffness");
  if (json.contains("stiffness_E") || json.contains("stiffness_F"))
    law.layers = LayerStiffness{number_at("stiffness_E"), number_at("stiffness_F")};
  law.damping = number_at("damping");
  law.transition_depth = number_at("transition_depth");
  law.friction = number_at("friction");
  law.slip_velocity = number_at("slip_velocity");
  law.max_penetration = number_at("max_penetration");
  law.damping_mode = read_at(json, "damping_mode", [](const Json& word) { return named(word, kDampingModes); });
  refuse_other_keys(json, {"stiffness", "stiffness_E", "stiffness_F", "damping", "transition_depth", "friction",
                           "slip_velocity", "max_penetration", "damping_mode"});
  return law;
}

Mode mode_from(const Json& json) {
  return named(json, kModes);
}

Scheme scheme_from(const Json& json) {
  return named(json, kSchemes);
}

}  // namespace pcm::compare
