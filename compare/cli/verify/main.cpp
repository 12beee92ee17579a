// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "compare/cli/frame/program.h"
#include "compare/cli/frame/programs.h"
#include "compare/cli/verify/verify.h"

namespace pcm::compare {
namespace {

struct Command {
  std::string_view name;
  const char* program;
  const char* description;
};

/// The subcommands that other programs have.
constexpr std::array kElsewhere = {
    Command{"answer", "pcm-judge", kAnswerDescription},       Command{"bench", "pcm-bench", kBenchDescription},
    Command{"contact", "pcm-contact", kContactDescription},   Command{"explain", "pcm-contact", kExplainDescription},
    Command{"inspect", "pcm-contact", kInspectDescription},   Command{"judge", "pcm-judge", kJudgeDescription},
    Command{"mesh", "pcm-contact", kMeshDescription},         Command{"poses", "pcm-judge", kPosesDescription},
    Command{"simulate", "pcm-simulate", kSimulateDescription}};

/// The first word that is no option: pcm's own options have no values.
std::string_view command_word(int argc, char** argv) {
  char** const word = std::find_if(argv + std::min(argc, 1), argv + argc,
                                   [](std::string_view argument) { return !argument.starts_with('-'); });
  return word == argv + argc ? "" : *word;
}

Exit run_pcm(int argc, char** argv) {
  const std::string_view word = command_word(argc, argv);
  for (const Command& command : kElsewhere)
    if (word == command.name) become(command.program, argv);
  return run_command_line(argc, argv, [argv](CLI::App& program, Run& run) {
    for (const Command& command : kElsewhere) list_command(program, std::string(command.name), command.description);
    add_verify_command(program, run, [argv](const VerifyOptions& options) {
      if (asks_for_other_tables(options)) become("pcm-verify-other-tables", argv);
      return verify(options);
    });
  });
}

}  // namespace
}  // namespace pcm::compare

int main(int argc, char** argv) {
  return pcm::compare::exit_status_of([=] { return pcm::compare::run_pcm(argc, argv); });
}
