// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/lines/answers_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/judge/lines/answer_lines.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {

std::map<std::string_view, std::size_t> questions_by_id(const PosedQuestions& posed) {
  std::map<std::string_view, std::size_t> by_id;
  for (std::size_t k = 0; k < posed.questions.size(); ++k) by_id.emplace(posed.questions[k].id, k);
  return by_id;
}

AnswersFile::AnswersFile(const std::filesystem::path& path, const PosedQuestions& posed)
    : lines_(path), posed_(posed), by_id_(questions_by_id(posed)), answered_at_(posed.questions.size()) {}

std::optional<Reply> AnswersFile::next() {
  while (const std::optional<Json> json = lines_.next()) {
    const bool is_first = std::exchange(at_first_, false);
    try {
      if (is_first && json->contains("format"))
        check_answers_header(*json, posed_);
      else
        return reply_from(*json);
    } catch (const BadInput& error) {
      throw BadInput(lines_.place() + ": " + error.what());
    }
  }
  return std::nullopt;
}

Reply AnswersFile::reply_from(const Json& json) {
  const std::string id = text_at(json, "id");
  const auto known = by_id_.find(id);
  if (known == by_id_.end())
    throw BadInput("no pose is called " + in_quotes(id) + "; copy the id from the line of poses.jsonl that it answers");
  const std::size_t question = known->second;
  std::int64_t& answered_at = answered_at_[question];
  if (answered_at != 0)
    throw BadInput(fmt::format("{} is answered a second time; line {} has answered it", in_quotes(id), answered_at));
  Reply reply;
  reply.question = question;
  reply.line = lines_.line();
  reply.answer = answer_from(json, posed_, posed_.questions[question]);
  answered_at = reply.line;
  return reply;
}

std::string AnswersFile::missing() const {
  const auto first = std::find(answered_at_.begin(), answered_at_.end(), 0);
  if (first == answered_at_.end()) return "";
  return fmt::format("{}: {} of {} poses have no answer, the first is {}; where an engine has none, write the id alone",
                     lines_.name(), std::count(first, answered_at_.end(), 0), answered_at_.size(),
                     in_quotes(posed_.questions[static_cast<std::size_t>(first - answered_at_.begin())].id));
}

}  // namespace pcm::compare
