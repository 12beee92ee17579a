// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/judge/answer.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "compare/cli/frame/programs.h"
#include "compare/judge/engines/own_answers.h"
#include "compare/judge/lines/answer_lines.h"
#include "compare/judge/poses/poses_folder.h"
#include "pcm/bad_input.h"

namespace pcm::compare {
namespace {

struct AnswerOptions {
  std::optional<std::string> poses;
  std::string engine = "fast";
  bool hexadecimal = false;
};

Exit answer(const AnswerOptions& options) {
  const Engine engine = engine_named(options.engine);
  const Notation notation = options.hexadecimal ? Notation::hexadecimal : Notation::decimal;
  const std::filesystem::path folder = options.poses.value_or(""),
                              file = options.poses ? folder / kPosesFile : std::filesystem::path("/dev/stdin");
  PosesReader reader(file, folder);
  OwnAnswers own(engine, reader.surfaces());
  if (options.poses) {
    Json header{{"format", kAnswersFormat}, {"engine", "pcm " + options.engine}};
    for (const PosedSurface& surface : reader.surfaces()) header["surfaces"][surface.name] = surface.sha256;
    std::cout << dump_exactly(header) << '\n';
  }
  while (const std::optional<PosedQuestion> question = reader.next()) {
    GivenAnswer given;
    try {
      given = own.answer(*question);
    } catch (const BadInput& error) {
      throw BadInput(reader.lines().place() + ": " + error.what());
    }
    std::cout << dump_exactly(answer_json(question->id, given, notation)) << '\n';
    if (!options.poses) flush_output();  // whoever asks is waiting
  }
  if (options.poses) reader.require_all();
  return Exit::success;
}

}  // namespace

void add_answer_command(CLI::App& program, Run& run) {
  auto options = std::make_shared<AnswerOptions>();
  CLI::App* command = program.add_subcommand("answer", kAnswerDescription);
  command->footer(
      "What is printed is what 'pcm judge' reads (docs/judge.md). Without --poses it is one end of a conversation: "
      "the\n"
      "lines of poses.jsonl come by standard input, and each pose is answered before the next one is read.\n"
      "Examples:\n"
      "  pcm answer --poses poses > answers.jsonl\n"
      "  pcm poses --out barycentric --scheme barycentric\n"
      "  pcm judge --poses barycentric --command 'pcm answer --engine published-2003'");
  command->add_option("--poses", options->poses, "Folder that 'pcm poses' has written (default: standard input)")
      ->type_name("DIR");
  command
      ->add_option("--engine", options->engine,
                   "Who answers: fast (default), published-2003 (no areas, no volume) or published-2023 (elements, "
                   "force and torque only); the last two in the barycentric scheme")
      ->type_name("WHO")
      ->check(CLI::IsMember({"fast", "published-2003", "published-2023"}));
  command->add_flag("--hex", options->hexadecimal, "Doubles as C hexadecimal floating point in quotes");
  command->callback([options, &run] { run = [options] { return answer(*options); }; });
}

}  // namespace pcm::compare
