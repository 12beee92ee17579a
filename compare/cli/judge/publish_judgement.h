// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "compare/judge/judgement/judging_report.h"

namespace pcm::compare {

/// The tables and the verdict, on the screen and, where there is a folder, in its files, with a case file of each of
/// the first wrong answers of a stratum. `ended`: what ended it before all was judged; empty where nothing did.
void publish_judgement(const Judging& run, const JudgingSetup& setup,
                       const std::optional<std::filesystem::path>& folder, const std::string& ended);

}  // namespace pcm::compare
