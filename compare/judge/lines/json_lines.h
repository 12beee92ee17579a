// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "compare/io/json/strict_json.h"

namespace pcm::compare {

/// Longer ones are refused: what sends them has gone wrong.
inline constexpr std::size_t kLongestJsonLine = std::size_t{1} << 26;

/// The JSON object that a line is. Throws BadInput where it is none.
Json object_from_line(std::string_view line);

/// A file of JSON objects, one a line, read object by object; blank lines are skipped, a leading UTF-8 byte order mark
/// too.
class JsonLines {
 public:
  /// Throws BadInput where `path` is no readable file.
  explicit JsonLines(const std::filesystem::path& path);

  /// The next object; none at the end. Throws BadInput with file and line for a line that is none, or only half of one.
  std::optional<Json> next();

  /// Of the last object, from 1.
  std::int64_t line() const { return line_; }
  /// "file:line" of it, for messages.
  std::string place() const { return place(line_); }
  std::string place(std::int64_t line) const { return name_ + ":" + std::to_string(line); }
  const std::string& name() const { return name_; }

 private:
  /// False at the end of the file, or where it can't be read.
  bool read_line(std::string& text);

  std::string name_;
  std::ifstream file_;
  std::int64_t line_ = 0;
};

}  // namespace pcm::compare
