// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "compare/cli/verify/verify_options.h"
#include "compare/hard_poses/search.h"

namespace pcm::compare {

/// What the options ask for. Throws BadInput where a file is no surface or no case, or a surface too large, and where
/// --out would remove a case that --from names.
SearchPlan search_plan(const VerifyOptions& options);

/// `pcm verify --search`: climbs to hard states (compare/hard_poses/search.h) on `jobs` threads, prints how hard they
/// are and the verdict on them, and writes into the folder search.md, .csv and .json, hardest.csv, and into its folder
/// `hardest` case files of the hardest and of those with a disagreement.
Exit verify_search(const SearchPlan& plan, int jobs, const std::optional<std::filesystem::path>& folder);

}  // namespace pcm::compare
