// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::compare {

/// `pcm mesh check FILE...`: what each surface consists of, what makes it unfit for contact and what is merely
/// remarkable about it, with the elements concerned. Status 1 where one is unfit, 2 where one can't be read.
void add_mesh_check_command(CLI::App& mesh, Run& run);

}  // namespace pcm::compare
