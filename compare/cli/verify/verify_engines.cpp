// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_engines.h"

#include <fmt/core.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/wrong_answers/engine_comparison_report.h"
#include "meshes/files/text_file.h"

namespace pcm::compare {

Exit verify_engines(VerificationPlan plan, const std::vector<Engine>& engines, int jobs,
                    const std::optional<std::filesystem::path>& folder, const std::function<bool()>& stop,
                    const std::function<void(std::int64_t)>& progress) {
  const EngineComparison result = compare_engines(std::move(plan), engines, jobs, stop, progress);
  const Table table = engine_comparison_table(result);
  std::string omissions;
  for (const std::string& omission : result.omissions) omissions += omission + "\n";
  const std::string after = fmt::format("\n{}{}{}\n", engine_comparison_on_shallow_poses(result), omissions,
                                        engine_comparison_verdict(result));
  if (folder) {
    write_text_file(*folder / "wrong_answers.md",
                    "# Wrong answers by stratum\n\n" + engine_comparison_legend() + "\n" + markdown(table) + after);
    write_text_file(*folder / "wrong_answers.csv", csv(table));
    const nlohmann::ordered_json whole{{"seed", result.seed}, {"complete", result.finished}, {"strata", json(table)}};
    write_text_file(*folder / "wrong_answers.json", whole.dump(1) + "\n");
  }
  std::cout << engine_comparison_legend() << '\n' << on_screen(table) << after;
  return result.finished && !result.anything_wrong() ? Exit::success : Exit::negative;
}

}  // namespace pcm::compare
