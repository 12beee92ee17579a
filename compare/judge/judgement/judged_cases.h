// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "compare/io/json/exact_json.h"
#include "compare/judge/judgement/judging.h"

/// The case files of `pcm judge --out`. Other commands may have case files in the same folder, those of `pcm verify`
/// under names of the same poses: which are its own a judgement remembers in judgement.json, under "cases".
namespace pcm::compare {

/// Removes those of the judgement that the folder's judgement.json tells of, as far as they are still what it wrote.
/// Throws BadInput where one can't be removed.
void remove_judged_cases(const std::filesystem::path& folder);

/// Writes a case file of each wrong answer that the run holds. Returns them for judgement.json: name and SHA-256 of
/// each.
Json write_judged_cases(const std::filesystem::path& folder, const Judging& run);

}  // namespace pcm::compare
