// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::compare {

/// `pcm answer`: the engines of this project as foreign ones (judge/engines/own_answers.h).
void add_answer_command(CLI::App& program, Run& run);

}  // namespace pcm::compare
