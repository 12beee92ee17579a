// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "compare/cli/frame/command_line.h"
#include "compare/verify/run/verification_plan.h"
#include "compare/wrong_answers/tested_engine.h"

namespace pcm::compare {

/// `pcm verify --engine A,B`: wrong answers of several engines by stratum, side by side. Prints table and verdict; with
/// a folder, writes wrong_answers.md, .csv and .json there. The verdict is negative where any of them was wrong or the
/// run was stopped.
Exit verify_engines(VerificationPlan plan, const std::vector<Engine>& engines, int jobs,
                    const std::optional<std::filesystem::path>& folder, const std::function<bool()>& stop,
                    const std::function<void(std::int64_t)>& progress);

}  // namespace pcm::compare
