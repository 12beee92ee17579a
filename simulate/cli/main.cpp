// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/program.h"
#include "simulate/cli/simulate.h"

int main(int argc, char** argv) {
  using namespace pcm;
  return compare::exit_status_of([=] { return compare::run_command_line(argc, argv, simulate::add_simulate_command); });
}
