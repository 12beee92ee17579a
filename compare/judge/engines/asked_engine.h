// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "compare/judge/engines/conversation.h"
#include "compare/judge/lines/posed_question.h"

namespace pcm::compare {

/// An engine that is asked pose by pose.
class AskedEngine {
 public:
  /// `folder`: where the surfaces lie; the engine is told their absolute paths. The questions must outlive this.
  /// `stop`: see Conversation.
  AskedEngine(const std::string& command, const PosedQuestions& posed, const std::filesystem::path& folder,
              Conversation::Seconds limit, std::function<bool()> stop = {});

  /// Asks question number k. A line that is no answer to it (answer_lines.h) is garbage. None where it was stopped.
  std::optional<Reply> ask(std::size_t k);

 private:
  const PosedQuestions& posed_;
  Conversation conversation_;
};

}  // namespace pcm::compare
