// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/question_json.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include "compare/io/names.h"
#include "meshes/files/parse_number.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

constexpr std::array kSchemes = {Scheme::barycentric, Scheme::clipped};
constexpr std::array kModes = {Mode::E, Mode::F, Mode::both};
constexpr std::array kDampingModes = {DampingMode::no_tension, DampingMode::full, DampingMode::compression};

/// The one of the values that goes by that name.
template <class Value, std::size_t N>
Value named(const Json& json, const std::array<Value, N>& values) {
  const auto word = json.get<std::string>();
  std::string known;
  for (const Value value : values) {
    if (word == name(value)) return value;
    known += (known.empty() ? "" : ", ") + std::string(name(value));
  }
  throw BadInput(in_quotes(word) + " is none of " + known);
}

double number_at(const Json& json, const char* key) {
  const Json& value = json.at(key);
  try {
    return number_from(value);
  } catch (const BadInput& error) {
    throw BadInput(std::string(key) + ": " + error.what());
  }
}

}  // namespace

std::string hexadecimal(double x) {
  return fmt::format("{:a}", x);
}

double number_from(const Json& json) {
  if (!json.is_string()) throw BadInput(json.dump() + " is no number in quotes, such as \"0x1.8p-3\"");
  const auto word = json.get<std::string>();
  if (word == "inf") return std::numeric_limits<double>::infinity();
  const std::optional<double> value = parse_number(word);
  if (!value) throw BadInput(in_quotes(word) + " is no number");
  return *value;
}

Json law_json(const ContactLaw& law) {
  Json json;
  json["stiffness"] = hexadecimal(law.stiffness);
  if (law.layers) {
    json["stiffness_E"] = hexadecimal(law.layers->c_E);
    json["stiffness_F"] = hexadecimal(law.layers->c_F);
  }
  json["damping"] = hexadecimal(law.damping);
  json["transition_depth"] = hexadecimal(law.transition_depth);
  json["friction"] = hexadecimal(law.friction);
  json["slip_velocity"] = hexadecimal(law.slip_velocity);
  json["max_penetration"] = hexadecimal(law.max_penetration);
  json["damping_mode"] = std::string(name(law.damping_mode));
  return json;
}

ContactLaw law_from(const Json& json) {
  ContactLaw law;
  law.stiffness = number_at(json, "stiffness");
  if (json.contains("stiffness_E"))
    law.layers = LayerStiffness{number_at(json, "stiffness_E"), number_at(json, "stiffness_F")};
  law.damping = number_at(json, "damping");
  law.transition_depth = number_at(json, "transition_depth");
  law.friction = number_at(json, "friction");
  law.slip_velocity = number_at(json, "slip_velocity");
  law.max_penetration = number_at(json, "max_penetration");
  law.damping_mode = named(json.at("damping_mode"), kDampingModes);
  return law;
}

Mode mode_from(const Json& json) {
  return named(json, kModes);
}

Scheme scheme_from(const Json& json) {
  return named(json, kSchemes);
}

std::string description(const nlohmann::json::exception& error) {
  const std::string_view what = error.what();  // "[json.exception.NAME] what"
  return std::string(what.substr(what.find(']') + 2));
}

}  // namespace pcm::compare
