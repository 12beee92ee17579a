// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::compare {

/// `pcm mesh make NAME [--parameter=value...] [-o FILE]`: writes a generated surface as OBJ (meshes/generate/make.h).
void add_mesh_make_command(CLI::App& mesh, Run& run);

}  // namespace pcm::compare
