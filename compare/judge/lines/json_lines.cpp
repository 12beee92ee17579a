// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/lines/json_lines.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string>

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

}  // namespace

Json object_from_line(std::string_view line) {
  try {
    Json json = strict_json(line);
    if (!json.is_object()) throw BadInput("this is JSON, but no object: " + in_quotes(line));
    return json;
  } catch (const nlohmann::json::exception& error) {
    const std::string what = description(error);
    if (names_no_number(what)) throw BadInput("NaN and infinity are no answers, and no JSON: " + what);
    throw BadInput("this is no JSON object: " + what);
  }
}

JsonLines::JsonLines(const std::filesystem::path& path) : name_(path.string()), file_(path, std::ios::binary) {
  if (!file_.is_open() || std::filesystem::is_directory(path))
    throw BadInput(name_ + ": this is no readable file; check the path");
}

bool JsonLines::read_line(std::string& text) {
  std::array<char, 4096> part;
  for (text.clear();; file_.clear()) {
    file_.getline(part.data(), part.size());
    const auto count = static_cast<std::size_t>(file_.gcount());
    if (file_.good()) {
      text.append(part.data(), count - 1);  // the line feed is counted
      return true;
    }
    text.append(part.data(), count);
    if (file_.bad() || file_.eof()) return !file_.bad() && !text.empty();
    if (text.size() > kLongestJsonLine)
      throw BadInput(place(line_ + 1) + ": this line is longer than 64 MiB; give one object a line");
  }
}

std::optional<Json> JsonLines::next() {
  for (std::string text; read_line(text);) {
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
