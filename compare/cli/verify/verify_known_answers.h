// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "compare/cli/frame/command_line.h"
#include "compare/known_answers/known_answers.h"

namespace pcm::compare {

/// `pcm verify --known-answers`: prints the summary of all known answers and identities on `jobs` threads, and writes
/// the tables into the folder: a page a case, known_answers.csv and .json, identities.md and .csv.
Exit verify_known_answers(Extent extent, std::uint64_t seed, int jobs,
                          const std::optional<std::filesystem::path>& folder);

}  // namespace pcm::compare
