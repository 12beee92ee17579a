// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::simulate {

/// Adds `pcm simulate SCENE`.
void add_simulate_command(CLI::App& program, compare::Run& run);

}  // namespace pcm::simulate
