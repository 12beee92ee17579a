// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/io/json/question_json.h"
#include "compare/judge/lines/json_lines.h"
#include "compare/judge/lines/posed_question.h"

namespace pcm::compare {

inline constexpr const char* kPosesFormat = "pcm poses 1";
inline constexpr const char* kPosesFile = "poses.jsonl";

/// The first line of poses.jsonl. `poses`: how many follow; `origin`: where they come from, in words.
Json poses_header(const std::vector<PosedSurface>& surfaces, std::int64_t poses, const std::string& origin);

/// A line for each pose (pose.schema.json).
Json pose_json(const PosedQuestion& question, const std::vector<PosedSurface>& surfaces, Notation notation);

/// Reads poses one by one.
class PosesReader {
 public:
  /// Reads the first line and the surfaces it names, whose files are sought in `folder`. Throws BadInput, with file and
  /// line, for another format, or a surface whose file has another SHA-256 than the line says.
  PosesReader(const std::filesystem::path& file, const std::filesystem::path& folder);

  const std::vector<PosedSurface>& surfaces() const { return surfaces_; }
  /// The next pose; none at the end. Throws BadInput, with file and line, for what is none.
  std::optional<PosedQuestion> next();
  /// At the end. Throws BadInput where these were not as many poses as the first line promises.
  void require_all() const;
  const JsonLines& lines() const { return lines_; }

 private:
  JsonLines lines_;
  std::vector<PosedSurface> surfaces_;
  std::size_t promised_ = 0, read_ = 0;
};

/// Reads a whole folder back. Throws BadInput as PosesReader, and where two poses have one id, or some are missing.
PosedQuestions read_poses_folder(const std::filesystem::path& folder);

}  // namespace pcm::compare
