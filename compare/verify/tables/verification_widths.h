// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compare/io/tables/column_units.h"
#include "compare/verify/run/verify.h"

/// How wide the checks behind a verdict were: bounds in units of what they hold. The same bit for bit whenever the plan
/// is.
namespace pcm::compare {

/// For each stratum, scheme and kind of check: how many, quantiles of their widths, how many were infinite, wider than
/// what they held, or of 0; and why, for each kind.
std::string widths_markdown(const Verification& run);
/// The same numbers.
std::string widths_csv(const Verification& run);
ColumnUnits widths_units();
nlohmann::ordered_json widths_json(const Verification& run);

/// On one screen: a row a kind and scheme, medians by stratum.
std::string widths_summary(const Verification& run);

}  // namespace pcm::compare
