// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_error_budget.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/error_budget/error_budget.h"
#include "compare/known_answers/report.h"
#include "meshes/files/text_file.h"

namespace pcm::compare {
namespace {

void write_tables(const std::filesystem::path& folder, const std::vector<KnownAnswerResult>& budget, bool met) {
  for (const KnownAnswerResult& result : budget)
    write_text_file(folder / (result.problem.id + ".md"), problem_markdown(result));
  write_text_file(folder / "error_budget.md", error_budget_markdown(budget));
  write_text_file(folder / "error_budget.csv", rows_csv(budget));
  const nlohmann::ordered_json whole{{"verdict", {{"met", met}}}, {"cases", cases_json(budget)}};
  write_text_file(folder / "error_budget.json", whole.dump(1) + "\n");
}

}  // namespace

Exit verify_error_budget(Extent extent, int jobs, const std::optional<std::filesystem::path>& folder) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const std::vector<KnownAnswerResult> budget = error_budget(extent, jobs, [&](const std::string& what) {
    if (terminal) std::cerr << fmt::format("\r{:<60}", what) << std::flush;
  });
  if (terminal) std::cerr << fmt::format("\r{:<60}\r", "");
  const bool met =
      std::all_of(budget.begin(), budget.end(), [](const KnownAnswerResult& result) { return result.missed() == 0; });
  if (folder) write_tables(*folder, budget, met);
  std::cout << error_budget_summary(budget) << error_budget_verdict(budget) << '\n';
  return met ? Exit::success : Exit::negative;
}

}  // namespace pcm::compare
