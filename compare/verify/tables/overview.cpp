// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/tables/overview.h"

#include <fmt/core.h>

#include "compare/verify/run/run_verdict.h"

namespace pcm::compare {
namespace {

TableCell small_number(double x) {
  return {fmt::format("{:.1e}", x), x};
}

std::vector<TableCell> row_of(const std::string& name, const Tally& tally) {
  std::vector<TableCell> row{name, count_cell(tally.poses), count_cell(tally.touching), count_cell(tally.disagreeing),
                             small_number(tally.disagreement_rate_bound())};
  for (std::size_t k = 0; k < kFirstBound; ++k)
    row.push_back(tally.errors[k].count() == 0 ? empty_cell() : small_number(measured_error(tally, k)));
  return row;
}

}  // namespace

Table overview_table(const Verification& run) {
  Table table{{{"stratum", "stratum", false},
               {"poses", "poses"},
               {"touching", "touching"},
               {"disagreements", "disagreements"},
               {"rate below", "rate_bound_95"}},
              {}};
  for (std::size_t k = 0; k < kFirstBound; ++k)
    table.columns.push_back({kErrorNames[k], std::string(kErrorNames[k]) + " error"});
  for (const NamedTally& stratum : run.by_stratum()) table.rows.push_back(row_of(stratum.name, stratum.tally));
  table.rows.push_back(row_of("all", run.total()));
  if (run.plan().recorded.empty()) table.rows.push_back(row_of("measured", measured_poses(run)));
  return table;
}

// Errors are relative, and divided by S/p.
ColumnUnits overview_units() {
  return {{"error", "S/p"}};
}

std::string overview_markdown(const Verification& run, const std::string& verdict) {
  return fmt::format(
      "# Verification at a glance\n\n"
      "The engine's answers, held against those of the oracle: discrete ones have to be equal, numbers within derived "
      "bounds. `poses`: one in several modes counts in each; `rate below`: upper end of the 95 % confidence interval "
      "of "
      "the rate of disagreements. Then the rounding errors of areas, vector areas, volume, greatest penetration, force "
      "and torque against the exact problem, relative and in units of S/p (S: greatest coordinate, p: mean thickness "
      "of the contact), at the 99.9th percentile, of penetrations at the 99th (of fewer than 1000 or 100 answers, all "
      "but the greatest); those of flipped poses are in areas and "
      "volume alone. `measured`: generic poses of the pairs that are not made to hurt, of which the verdict demands "
      "{:.0e} S/p.\n\n{}\n{}\n",
      kMeasure, markdown(overview_table(run)), verdict);
}

}  // namespace pcm::compare
