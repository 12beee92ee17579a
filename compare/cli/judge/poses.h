// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::compare {

/// `pcm poses`: writes what a verification asks, for engines of any make (judge/poses/write_poses.h).
void add_poses_command(CLI::App& program, Run& run);

}  // namespace pcm::compare
