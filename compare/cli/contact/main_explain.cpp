// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/contact/explain.h"
#include "compare/cli/frame/program.h"

int main(int argc, char** argv) {
  using namespace pcm::compare;
  return exit_status_of([=] { return run_command_line(argc, argv, add_explain_command); });
}
