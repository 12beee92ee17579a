// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "compare/cli/frame/command_line.h"

/// The frame of `pcm` and of the programs that it starts (programs.h).
namespace pcm::compare {

/// Does the work and gives the program's exit status; what is thrown becomes a line on standard error.
int exit_status_of(const std::function<Exit()>& work);

/// Reads the command line with the subcommands that `add_commands` adds, and does what it says.
Exit run_command_line(int argc, char** argv, const std::function<void(CLI::App&, Run&)>& add_commands);

/// Adds a subcommand that is only listed: whoever starts it starts another program.
void list_command(CLI::App& program, const std::string& name, const std::string& description);

}  // namespace pcm::compare
