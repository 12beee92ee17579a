// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_engines.h"

#include <fmt/core.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

#include "compare/io/json/question_json.h"
#include "compare/io/tables/report_folder.h"
#include "compare/verify/run/run_identity.h"
#include "compare/wrong_answers/engine_comparison_report.h"
#include "meshes/files/text_file.h"

namespace pcm::compare {

Exit verify_engines(VerificationPlan plan, const std::vector<Engine>& engines, int jobs,
                    const std::optional<std::filesystem::path>& folder, const std::function<bool()>& stop,
                    const std::function<void(std::int64_t)>& progress) {
  nlohmann::ordered_json question = question_of(plan);
  // The published algorithms are asked under the pairs' own laws.
  question.erase("law");
  for (std::size_t k = 0; k < plan.pairs.size(); ++k)
    question["pairs"][k]["law"] = law_json(plan.pairs[k].law, Notation::decimal);
  for (const Engine engine : engines) question["engines"].push_back(std::string(name(engine)));
  const EngineComparison result = compare_engines(std::move(plan), engines, jobs, stop, progress);
  const Table table = engine_comparison_table(result);
  std::string omissions;
  for (const std::string& omission : result.omissions) omissions += omission + "\n";
  const std::string after = fmt::format("\n{}{}{}\n", engine_comparison_on_shallow_poses(result), omissions,
                                        engine_comparison_verdict(result));
  std::cout << engine_comparison_legend() << '\n' << on_screen(table) << after;
  if (folder) {
    question["complete"] = result.finished;
    ReportFolder report(*folder, "wrong_answers", std::move(question));
    report.markdown("wrong_answers",
                    "# Wrong answers by stratum\n\n" + engine_comparison_legend() + "\n" + markdown(table) + after);
    report.csv("wrong_answers", csv(table), {});
    report.json("wrong_answers", {{"seed", result.seed}, {"complete", result.finished}, {"strata", json(table)}});
    report.finish();
  }
  return result.finished && !result.anything_wrong() ? Exit::success : Exit::negative;
}

}  // namespace pcm::compare
