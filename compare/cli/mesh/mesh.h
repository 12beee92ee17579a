// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::compare {

/// `pcm mesh check|make|convert`: says what is wrong with surfaces, generates them, turns other formats into OBJ.
void add_mesh_command(CLI::App& program, Run& run);

}  // namespace pcm::compare
