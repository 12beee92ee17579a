// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>

#include "compare/judge/judgement/judging_report.h"

namespace pcm::compare {

/// What a judgement leaves in its folder beside the case files, and its name in there.
inline constexpr const char* kJudgementReport = "judgement";
inline constexpr std::initializer_list<const char*> kJudgementFiles = {
    "judgement.md", "judgement.tex", "judgement.json", "strata.csv", "facts.csv", "pairs.csv"};

/// The tables and the verdict, on the screen and, where there is a folder, in its files, with a case file of each of
/// the first wrong answers of a stratum. `ended`: what ended it before all was judged; empty where nothing did.
void publish_judgement(const Judging& run, const JudgingSetup& setup,
                       const std::optional<std::filesystem::path>& folder, const std::string& ended);

}  // namespace pcm::compare
