// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "compare/judge/engines/asked_engine.h"
#include "compare/judge/lines/posed_question.h"
#include "compare/judge/lines/reply.h"

namespace pcm::compare {

/// What is judged, one after the other, from a file or from an engine that is asked. The questions must outlive it.
struct ReplySource {
  std::function<std::optional<Reply>()> next;           ///< none at the end, or where the engine was stopped
  std::function<std::string(std::int64_t line)> place;  ///< what stands before a convention's name in a message
  std::function<std::string()> missing;                 ///< at the end: what is wrong with all as a whole, or empty
};

ReplySource source_of_file(const std::string& path, const PosedQuestions& posed);
ReplySource source_of_engine(std::shared_ptr<AskedEngine> engine, const PosedQuestions& posed);

/// What came back for each pose, if anything did. A file is read whole; an engine is asked when a pose's turn comes, by
/// one thread at a time.
using ReplyTo = std::function<std::optional<Reply>(std::size_t question)>;

/// `complaint`: what is wrong with the file, or with it as a whole; what came before it counts.
ReplyTo replies_of_file(const std::string& path, const PosedQuestions& posed, std::string& complaint);
ReplyTo replies_of_engine(std::shared_ptr<AskedEngine> engine);

}  // namespace pcm::compare
