// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::compare {

/// `pcm explain`: why an answer is what it is (explain/explain.h).
void add_explain_command(CLI::App& program, Run& run);

}  // namespace pcm::compare
