// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compare/io/tables/column_units.h"
#include "compare/verify/run/verify.h"

/// The tables of a verification. All but the times are the same bit for bit whenever the plan is.
namespace pcm::compare {

/// Agreement and rounding errors, a row for each pair, stratum, scheme and mode, for each stratum, scheme and mode, for
/// each mode, and for all; and how wide the checks were.
std::string verification_markdown(const Verification& run);
/// The same numbers, and each kind of disagreement in a column of its own.
std::string verification_csv(const Verification& run);
ColumnUnits verification_units();
nlohmann::ordered_json verification_json(const Verification& run);

/// Median times of the engine, of the oracle on the rounded and of the oracle on the exact problem.
std::string times_markdown(const Verification& run);

}  // namespace pcm::compare
