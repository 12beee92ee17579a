// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/engines/replies.h"

#include <mutex>
#include <utility>
#include <vector>

#include "compare/judge/lines/answers_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {

ReplySource source_of_file(const std::string& path, const PosedQuestions& posed) {
  const auto file = std::make_shared<AnswersFile>(path, posed);
  return {[file] { return file->next(); }, [file](std::int64_t line) { return file->place(line); },
          [file] { return file->missing(); }};
}

ReplySource source_of_engine(std::shared_ptr<AskedEngine> engine, const PosedQuestions& posed) {
  return {[engine = std::move(engine), &posed, k = std::size_t{0}]() mutable -> std::optional<Reply> {
            if (k == posed.questions.size()) return std::nullopt;
            return engine->ask(k++);
          },
          [](std::int64_t) { return std::string("--command"); }, [] { return std::string(); }};
}

ReplyTo replies_of_file(const std::string& path, const PosedQuestions& posed, std::string& complaint) {
  const auto replies = std::make_shared<std::vector<std::optional<Reply>>>(posed.questions.size());
  AnswersFile file(path, posed);
  try {
    while (std::optional<Reply> reply = file.next()) (*replies)[reply->question] = std::move(reply);
    complaint = file.missing();
  } catch (const BadInput& error) {
    complaint = error.what();
  }
  return [replies](std::size_t question) { return (*replies)[question]; };
}

ReplyTo replies_of_engine(std::shared_ptr<AskedEngine> engine) {
  const auto asking = std::make_shared<std::mutex>();
  return [engine = std::move(engine), asking](std::size_t question) -> std::optional<Reply> {
    const std::lock_guard lock(*asking);
    return engine->ask(question);
  };
}

}  // namespace pcm::compare
