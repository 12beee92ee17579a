// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/judge/lines/json_lines.h"
#include "compare/judge/lines/posed_question.h"
#include "compare/judge/lines/reply.h"

namespace pcm::compare {

/// The questions by their ids.
std::map<std::string_view, std::size_t> questions_by_id(const PosedQuestions& posed);

/// A file of answers to posed questions, in any order, read answer by answer.
class AnswersFile {
 public:
  /// The questions must outlive this. Throws BadInput where `path` is no readable file.
  AnswersFile(const std::filesystem::path& path, const PosedQuestions& posed);

  /// The next answer; none at the end. Throws BadInput, with file and line, for what is no answer (answer_lines.h), an
  /// id that no pose has, and one that has been answered.
  std::optional<Reply> next();
  /// "file:line"
  std::string place(std::int64_t line) const { return lines_.place(line); }
  /// Which poses have no answer so far, in a line; empty where none.
  std::string missing() const;

 private:
  Reply reply_from(const Json& json);

  JsonLines lines_;
  bool at_first_ = true;  ///< which may be the header
  const PosedQuestions& posed_;
  std::map<std::string_view, std::size_t> by_id_;
  std::vector<std::int64_t> answered_at_;  ///< by question: the line, 0 for none
};

}  // namespace pcm::compare
