// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "compare/poses/rotation.h"
#include "pcm/inputs.h"

namespace pcm::compare {

/// Where F is, seen from E, and how it moves (PCM section 1).
struct State {
  Pose pose;
  Velocity velocity;
  double replaced_error = 0;  ///< of the orientation that was read, where another one was taken (rotation.h)
};

/// How a line begins: with the nine entries of A by rows, or with a unit quaternion, whose real part w comes first or
/// last.
enum class OrientationNotation : std::uint8_t { matrix, wxyz, xyzw };

struct PoseReading {
  OrientationNotation notation = OrientationNotation::matrix;
  bool orthonormalise = false;  ///< orientations with few digits are replaced by the nearest rotation (rotation.h)
  double metres_per_unit = 1;   ///< of r and v
};

/// The state that one line of a poses file holds; none where it is blank or only a comment (from `#` on).
///
/// The orientation, nine numbers or four, then r; or then v and w as well, which are zero otherwise. Numbers are
/// separated by blanks and written in decimal or as C hexadecimal floats. Throws BadInput, without file and line, for
/// anything else, for an orientation that is no rotation and for numbers that are not finite, in metres too.
std::optional<State> parse_state(std::string_view line, const PoseReading& reading = {});

/// Reads a poses file state by state, in constant memory, so it may be endless or a pipe. Lines end with a line feed, a
/// carriage return or both; a leading UTF-8 byte order mark is skipped.
class PosesFile {
 public:
  /// `path` "-" is standard input. Throws BadInput where `path` is no readable file.
  explicit PosesFile(const std::filesystem::path& path, const PoseReading& reading = {});

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

  std::istream& in();

  std::string name_;
  PoseReading reading_;
  bool standard_input_;
  std::ifstream file_;
  std::string text_;
  std::int64_t line_ = 0;
  bool empty_ = true;
};

}  // namespace pcm::compare
