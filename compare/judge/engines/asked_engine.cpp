// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/engines/asked_engine.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "compare/judge/lines/answer_lines.h"
#include "compare/judge/lines/json_lines.h"
#include "compare/judge/poses/poses_folder.h"
#include "meshes/files/text_file.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

std::string greeting(const PosedQuestions& posed, const std::filesystem::path& folder) {
  std::vector<PosedSurface> surfaces = posed.surfaces;
  for (PosedSurface& surface : surfaces) surface.file = std::filesystem::absolute(folder / surface.file).string();
  return dump_exactly(poses_header(surfaces, std::ssize(posed.questions), "pcm judge --command"));
}

}  // namespace

AskedEngine::AskedEngine(const std::string& command, const PosedQuestions& posed, const std::filesystem::path& folder,
                         Conversation::Seconds limit, std::function<bool()> stop)
    : posed_(posed), conversation_(words_of_command(command), greeting(posed, folder), limit, std::move(stop)) {}

std::optional<Reply> AskedEngine::ask(std::size_t k) {
  const PosedQuestion& question = posed_.questions[k];
  const std::optional<Conversation::Said> said =
      conversation_.ask(dump_exactly(pose_json(question, posed_.surfaces, Notation::decimal)));
  if (!said) return std::nullopt;
  Reply reply;
  reply.question = k;
  reply.breakdown = said->breakdown;
  reply.failure = said->failure;
  if (said->breakdown) return reply;
  try {
    const Json json = object_from_line(said->line);
    if (const std::string id = text_at(json, "id"); id != question.id)
      throw BadInput("this answers " + in_quotes(id) + ", which was not asked");
    reply.answer = answer_from(json, posed_, question);
  } catch (const BadInput& error) {
    reply.answer = {};
    reply.breakdown = Breakdown::garbage;
    reply.failure = error.what();
    conversation_.give_up();
  }
  return reply;
}

}  // namespace pcm::compare
