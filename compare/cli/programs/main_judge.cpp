// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What other engines take part by: pcm answer, judge and poses.
#include "compare/cli/frame/program.h"
#include "compare/cli/judge/answer.h"
#include "compare/cli/judge/judge.h"
#include "compare/cli/judge/poses.h"

int main(int argc, char** argv) {
  using namespace pcm::compare;
  return exit_status_of([=] {
    return run_command_line(argc, argv, [](CLI::App& program, Run& run) {
      add_answer_command(program, run);
      add_judge_command(program, run);
      add_poses_command(program, run);
    });
  });
}
