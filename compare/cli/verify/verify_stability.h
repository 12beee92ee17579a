// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/cli/frame/command_line.h"
#include "compare/known_answers/known_answers.h"

namespace pcm::compare {

/// `pcm verify --stability`: prints rounding errors beside the condition of the problem over six sweeps
/// (compare/stability/stability.h), on `jobs` threads, and writes tables and plots into the folder: stability.md, .csv
/// and .json, flatness.csv, and stability_SWEEP.svg.
Exit verify_stability(Extent extent, std::uint64_t seed, int jobs, const std::optional<std::filesystem::path>& folder);

/// The names of all that it leaves there.
std::vector<std::string> stability_files();

}  // namespace pcm::compare
