// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "compare/cli/frame/command_line.h"
#include "compare/known_answers/known_answers.h"

namespace pcm::compare {

/// `pcm verify --audits`: prints work left over, tangential force and jumps of closed loops (audits.h), on `jobs`
/// threads, and writes the tables into the folder: audits.md, .csv and .json.
Exit verify_audits(Extent extent, int jobs, const std::optional<std::filesystem::path>& folder);

}  // namespace pcm::compare
