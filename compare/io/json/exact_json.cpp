// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/json/exact_json.h"

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "compare/io/json/json_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

void append_double(double value, const std::string& key, std::string& text) {
  if (!std::isfinite(value))
    throw BadInput("'" + key + "' is too large for a double; choose units in which the numbers are smaller");
  std::array<char, 32> digits{};  // The longest shortest form is "-2.2250738585072014e-308", 24 characters.
  const std::to_chars_result result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  const std::string_view shortest(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
  text += shortest;
  if (shortest.find_first_of(".e") == std::string_view::npos) text += ".0";
}

/// Recursive in the depth of nesting only.
void append(const Json& value, const std::string& key, std::string& text) {
  const char* separator = "";
  if (value.is_object()) {
    text += '{';
    for (const auto& [name, member] : value.items()) {
      text += separator;
      text += Json(name).dump();
      text += ':';
      append(member, name, text);
      separator = ",";
    }
    text += '}';
  } else if (value.is_array()) {
    text += '[';
    for (const Json& item : value) {
      text += separator;
      append(item, key, text);
      separator = ",";
    }
    text += ']';
  } else if (value.is_number_float()) {
    append_double(value.get<double>(), key, text);
  } else {
    text += json_line(value);
  }
}

}  // namespace

Json json_vector(const Eigen::Vector3d& vector) {
  return Json::array({vector.x(), vector.y(), vector.z()});
}

std::string dump_exactly(const Json& value) {
  std::string text;
  append(value, "value", text);
  return text;
}

}  // namespace pcm::compare
