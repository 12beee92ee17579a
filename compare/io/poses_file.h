// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "pcm/inputs.h"

namespace pcm::compare {

/// Where F is, seen from E, and how it moves (PCM section 1).
struct State {
  Pose pose;
  Velocity velocity;
};

/// Whether max |A^T A - I| <= 1e-9 and det A > 0; false where anything is not finite.
bool is_rotation(const Eigen::Matrix3d& A);

/// The state that one line of a poses file holds; none where it is blank or only a comment (from `#` on).
///
/// 12 numbers: A by rows, then r. 18: then v and w as well; they are zero otherwise. Numbers are separated by blanks
/// and written in decimal or as C hexadecimal floats. Throws BadInput, without file and line, for anything else, for
/// an A that is no rotation and for numbers that are not finite.
std::optional<State> parse_state(std::string_view line);

/// Reads a poses file state by state, in constant memory, so it may be endless or a pipe. Lines end with a line feed, a
/// carriage return or both; a leading UTF-8 byte order mark is skipped.
class PosesFile {
 public:
  /// Throws BadInput where `path` is no readable file.
  explicit PosesFile(const std::filesystem::path& path);

  /// The next state; none at the end. Throws BadInput with file and line for a malformed line, and for a file that ends
  /// without having held a pose.
  std::optional<State> next();

  /// "file:line" of the last state, for messages.
  std::string place() const;
  /// Its line, from 1.
  std::int64_t line() const { return line_; }

 private:
  /// Puts the next line into text_, without its ending and its comment; false at the end.
  bool next_line();

  std::string name_;
  std::ifstream file_;
  std::string text_;
  std::int64_t line_ = 0;
  bool empty_ = true;
};

}  // namespace pcm::compare
