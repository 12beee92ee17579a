// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "compare/cli/frame/command_line.h"
#include "compare/known_answers/known_answers.h"

namespace pcm::compare {

/// `pcm verify --error-budget`: prints the three kinds of error of the smooth bodies over resolutions, on `jobs`
/// threads, and writes the tables into the folder: error_budget.md, .csv and .json and a page a case.
Exit verify_error_budget(Extent extent, int jobs, const std::optional<std::filesystem::path>& folder);

}  // namespace pcm::compare
