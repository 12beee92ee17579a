// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::compare {

/// `pcm inspect`: walks a path of poses and prints where, by how much and why the elastic force jumps, and the work
/// done along it (force_jumps.h, path_report.h).
void add_inspect_command(CLI::App& program, Run& run);

}  // namespace pcm::compare
