// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/json/strict_json.h"

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "meshes/files/text_file.h"

namespace pcm::compare {
namespace {

/// Refuses while a text is parsed what the parser itself lets pass: a key that an object has twice, of which it takes
/// the last one, and nesting.
class Strictness {
 public:
  bool operator()(int levels_around, Json::parse_event_t event, Json& parsed) {
    const bool opens = event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    if (opens && static_cast<std::size_t>(levels_around) >= kMostJsonLevels)
      throw BadInput("lists and objects lie in one another more than " + std::to_string(kMostJsonLevels) +
                     " levels deep");
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

std::string description(const nlohmann::json::exception& error) {
  const std::string_view what = error.what();  // "[json.exception.NAME] what"
  return std::string(what.substr(what.find(']') + 2));
}

Json strict_json(std::string_view text) {
  Strictness strictness;
  return Json::parse(text, std::ref(strictness));
}

Json strict_json(std::string_view text, std::string_view otherwise) {
  try {
    return strict_json(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw BadInput(std::string(otherwise) + ": " + description(error));
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

const Json& value_at(const Json& object, const char* key) {
  if (!object.is_object()) throw BadInput(std::string("an object is wanted; this is of type ") + object.type_name());
  const auto found = object.find(key);
  if (found == object.end()) throw BadInput("\"" + std::string(key) + "\" is missing");
  return *found;
}

const Json& list_at(const Json& object, const char* key) {
  const Json& list = value_at(object, key);
  if (!list.is_array()) throw BadInput(std::string(key) + ": a list is wanted; this is of type " + list.type_name());
  return list;
}

std::string text_at(const Json& object, const char* key) {
  const Json& text = value_at(object, key);
  if (!text.is_string()) throw BadInput("\"" + std::string(key) + "\" is no text: " + text.dump());
  return text.get<std::string>();
}

}  // namespace pcm::compare
