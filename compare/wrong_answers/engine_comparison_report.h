// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/io/tables/table.h"
#include "compare/wrong_answers/engine_comparison.h"

namespace pcm::compare {

/// Wrong answers by stratum, the engines side by side.
Table engine_comparison_table(const EngineComparison& result);

/// What the table's columns are, in words for people.
std::string engine_comparison_legend();

/// How often force and torque of shallow generic poses are right, a line an engine. Empty without such poses.
std::string engine_comparison_on_shallow_poses(const EngineComparison& result);

/// The verdict in a line.
std::string engine_comparison_verdict(const EngineComparison& result);

}  // namespace pcm::compare
