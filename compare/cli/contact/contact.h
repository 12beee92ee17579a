// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/cli/frame/command_line.h"

namespace pcm::compare {

/// `pcm contact`: evaluates a pairing for each pose of a file (or for the identity pose, at rest) by the engine or by
/// the oracle, and prints one JSON object a line for each (contact_json.h).
void add_contact_command(CLI::App& program, Run& run);

}  // namespace pcm::compare
