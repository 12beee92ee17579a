// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/io/tables/column_units.h"
#include "compare/io/tables/table.h"
#include "compare/verify/run/verify.h"

namespace pcm::compare {

/// A verification on one page: a row for each stratum, for all, and for the generic poses whose rounding errors the
/// verdict holds to kMeasure. Errors are at the percentile that it is held to there.
Table overview_table(const Verification& run);
ColumnUnits overview_units();
/// With what its columns are, and the verdict.
std::string overview_markdown(const Verification& run, const std::string& verdict);

}  // namespace pcm::compare
