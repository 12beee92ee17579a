// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_error_budget.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/cli/frame/progress_line.h"
#include "compare/cli/verify/kept_folder.h"
#include "compare/error_budget/error_budget.h"
#include "compare/io/tables/report_folder.h"
#include "compare/known_answers/report.h"

namespace pcm::compare {
namespace {

void write_tables(const std::filesystem::path& path, const std::vector<KnownAnswerResult>& budget, Extent extent,
                  bool met) {
  ReportFolder folder(
      path, "error_budget",
      {{"meshes", extent == Extent::quick ? "quick" : "full"}, {"laws", "of each case its own, on its page"}});
  for (const KnownAnswerResult& result : budget) folder.markdown(result.problem.id, problem_markdown(result));
  folder.markdown("error_budget", error_budget_markdown(budget));
  folder.csv("error_budget", rows_csv(budget), rows_units());
  folder.json("error_budget", {{"verdict", {{"met", met}}}, {"cases", cases_json(budget)}});
  folder.finish();
}

}  // namespace

Exit verify_error_budget(Extent extent, int jobs, const std::optional<std::filesystem::path>& folder) {
  const ProgressLine progress;
  KeptValues kept = kept_values(folder, "error_budget", extent);
  const std::vector<KnownAnswerResult> budget =
      error_budget(extent, jobs, kept, [&](const std::string& what) { progress.show(what); });
  progress.wipe();
  const bool met =
      std::all_of(budget.begin(), budget.end(), [](const KnownAnswerResult& result) { return result.missed() == 0; });
  std::cout << error_budget_summary(budget) << error_budget_verdict(budget) << '\n';
  if (folder) {
    write_tables(*folder, budget, extent, met);
    kept.finish();
  }
  return met ? Exit::success : Exit::negative;
}

}  // namespace pcm::compare
