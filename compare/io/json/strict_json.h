// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "compare/io/json/exact_json.h"
#include "pcm/bad_input.h"

/// Readers that refuse what JSON's own parser lets pass, and say where.
namespace pcm::compare {

/// What is of any use has ten levels of lists and objects at most; what walks through a parsed text calls itself once a
/// level.
inline constexpr std::size_t kMostJsonLevels = 64;

/// What the library says is wrong, without its own name for it.
std::string description(const nlohmann::json::exception& error);

/// The value that a text is. Throws BadInput for an object that has a key twice and for nesting too deep for what walks
/// through it, and what the library throws where the text is no JSON.
Json strict_json(std::string_view text);
/// The same; throws BadInput that begins with `otherwise` where the text is no JSON.
Json strict_json(std::string_view text, std::string_view otherwise);

/// Throws BadInput naming the first key of the object that is none of the known ones.
void refuse_other_keys(const Json& object, std::initializer_list<std::string_view> known);

/// What `read` gives; what it or the library throws names the place: a file, a line, a key.
template <class Read>
auto within(const std::string& place, const Read& read) {
  try {
    return read();
  } catch (const nlohmann::json::exception& error) {
    throw BadInput(place + ": " + description(error));
  } catch (const BadInput& error) {
    throw BadInput(place + ": " + error.what());
  }
}

/// The value under a key, and the list and the text. Throw BadInput naming the key where there is none.
const Json& value_at(const Json& object, const char* key);
const Json& list_at(const Json& object, const char* key);
std::string text_at(const Json& object, const char* key);

/// What `read` makes of the value under a key; what it throws names the key.
template <class Read>
auto read_at(const Json& object, const char* key, const Read& read) {
  const Json& value = value_at(object, key);
  return within(key, [&] { return read(value); });
}

}  // namespace pcm::compare
