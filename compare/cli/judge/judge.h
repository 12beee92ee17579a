// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::compare {

/// `pcm judge`: holds answers, from a file or from an engine that is asked, against the oracle
/// (judge/judgement/judging.h).
void add_judge_command(CLI::App& program, Run& run);

}  // namespace pcm::compare
