// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::compare {

/// `pcm bench peers` and `pcm bench scaling`: how fast the engine is, beside others and over sizes.
void add_bench_command(CLI::App& program, Run& run);

}  // namespace pcm::compare
