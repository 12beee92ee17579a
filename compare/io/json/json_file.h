// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

namespace pcm::compare {

/// JSON as our files have it, indented for people. Names of surfaces and files in it may be no UTF-8.
inline std::string json_file_text(const nlohmann::ordered_json& json) {
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// The same as one line, without its end.
inline std::string json_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// What a file holds; discarded where there is none, or no JSON.
inline nlohmann::ordered_json json_or_discarded(const std::filesystem::path& file) {
  std::error_code none_there;
  if (!std::filesystem::is_regular_file(file, none_there)) return nlohmann::ordered_json::value_t::discarded;
  std::ifstream in(file);
  return nlohmann::ordered_json::parse(in, nullptr, false);
}

}  // namespace pcm::compare
