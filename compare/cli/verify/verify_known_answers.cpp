// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_known_answers.h"

#include <fmt/core.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/cli/frame/progress_line.h"
#include "compare/cli/verify/kept_folder.h"
#include "compare/io/tables/report_folder.h"
#include "compare/known_answers/report.h"

namespace pcm::compare {
namespace {

void write_tables(const std::filesystem::path& path, const KnownAnswersReport& report, Extent extent,
                  std::uint64_t seed) {
  ReportFolder folder(path, "known_answers",
                      {{"meshes", extent == Extent::quick ? "quick" : "full"},
                       {"seed", seed},
                       {"laws", "of each case its own, on its page"}});
  for (const KnownAnswerResult& result : report.problems) folder.markdown(result.problem.id, problem_markdown(result));
  folder.markdown("identities", identities_markdown(report.identities));
  folder.markdown("known_answers", known_answers_markdown(report));
  folder.csv("known_answers", rows_csv(report.problems), rows_units());
  folder.csv("identities", identities_csv(report.identities), {});
  folder.json("known_answers", known_answers_json(report));
  folder.finish();
}

}  // namespace

Exit verify_known_answers(Extent extent, std::uint64_t seed, int jobs,
                          const std::optional<std::filesystem::path>& folder) {
  const ProgressLine progress;
  KeptValues kept = kept_values(folder, "known_answers", extent);
  const KnownAnswersReport report =
      run_known_answers(extent, seed, jobs, kept, [&](const std::string& what) { progress.show(what); });
  progress.wipe();
#ifndef PCM_WITH_DYNAMICS
  std::cerr << "A12 to A17 are left out: this program was built without SUNDIALS\n";
#endif
  std::cout << known_answers_summary(report) << fmt::format("identities: seed {}\n", seed)
            << known_answers_verdict(report) << '\n';
  if (folder) {
    write_tables(*folder, report, extent, seed);
    kept.finish();
  }
  return report.met() ? Exit::success : Exit::negative;
}

}  // namespace pcm::compare
