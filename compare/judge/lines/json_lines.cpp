// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/lines/json_lines.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "compare/io/question_json.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// JSON has no word for what is no number, but Python and others write NaN and Infinity: the parser stops at their
/// first letter.
bool names_no_number(std::string_view message) {
  return message.ends_with("N'") || message.ends_with("I'") || message.ends_with("na'");
}

/// The deepest line that is any use has 4 levels. What walks through a parsed line calls itself once a level.
constexpr int kMostLevels = 64;

/// Refuses while a text is parsed what the parser itself lets pass: a key that an object has twice, of which it takes
/// the last one, and nesting too deep for what reads it.
class Strictness {
 public:
  bool operator()(int levels_around, Json::parse_event_t event, Json& parsed) {
    const bool opens = event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    if (opens && levels_around >= kMostLevels)
      throw BadInput("lists and objects lie in one another more than " + std::to_string(kMostLevels) + " levels deep");
    if (event == Json::parse_event_t::object_start) keys_.emplace_back();
    if (event == Json::parse_event_t::object_end) keys_.pop_back();
    if (event == Json::parse_event_t::key && !keys_.back().insert(parsed.get<std::string>()).second)
      throw BadInput("the key " + in_quotes(parsed.get<std::string>()) + " is there twice");
    return true;
  }

 private:
  std::vector<std::set<std::string>> keys_;  ///< of the objects that are open
};

}  // namespace

Json object_from_line(std::string_view line) {
  try {
    Strictness strictness;
    Json json = Json::parse(line, std::ref(strictness));
    if (!json.is_object()) throw BadInput("this is JSON, but no object: " + in_quotes(line));
    return json;
  } catch (const nlohmann::json::exception& error) {
    const std::string what = description(error);
    if (names_no_number(what)) throw BadInput("NaN and infinity are no answers, and no JSON: " + what);
    throw BadInput("this is no JSON object: " + what);
  }
}

void refuse_other_keys(const Json& object, std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    std::string words;
    for (const std::string_view word : known) words += (words.empty() ? "" : ", ") + std::string(word);
    throw BadInput("the key " + in_quotes(key) + " is none of " + words);
  }
}

std::string text_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) throw BadInput("\"" + std::string(key) + "\" is missing");
  if (!found->is_string()) throw BadInput("\"" + std::string(key) + "\" is no text: " + found->dump());
  return found->get<std::string>();
}

JsonLines::JsonLines(const std::filesystem::path& path) : name_(path.string()), file_(path, std::ios::binary) {
  if (!file_.is_open() || std::filesystem::is_directory(path))
    throw BadInput(name_ + ": this is no readable file; check the path");
}

std::optional<Json> JsonLines::next() {
  for (std::string text; std::getline(file_, text);) {
    ++line_;
    const bool is_last = file_.eof();  // and without a line feed
    std::string_view line = text;
    if (line_ == 1 && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    try {
      return object_from_line(line);
    } catch (const BadInput& error) {
      throw BadInput(place() + ": " + (is_last ? "the file ends within this line: " : "") + error.what());
    }
  }
  if (file_.bad()) throw BadInput(name_ + ": the file can't be read to its end");
  return std::nullopt;
}

}  // namespace pcm::compare
