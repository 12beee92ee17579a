// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_known_answers.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "compare/known_answers/report.h"
#include "meshes/files/text_file.h"

namespace pcm::compare {
namespace {

void write_tables(const std::filesystem::path& folder, const KnownAnswersReport& report) {
  for (const KnownAnswerResult& result : report.problems)
    write_text_file(folder / (result.problem.id + ".md"), problem_markdown(result));
  write_text_file(folder / "identities.md", identities_markdown(report.identities));
  write_text_file(folder / "known_answers.csv", rows_csv(report.problems));
  write_text_file(folder / "identities.csv", identities_csv(report.identities));
  write_text_file(folder / "known_answers.json", known_answers_json(report).dump(1) + "\n");
}

}  // namespace

Exit verify_known_answers(Extent extent, std::uint64_t seed, int jobs,
                          const std::optional<std::filesystem::path>& folder) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const KnownAnswersReport report = run_known_answers(extent, seed, jobs, [&](const std::string& what) {
    if (terminal) std::cerr << fmt::format("\r{:<60}", what) << std::flush;
  });
  if (terminal) std::cerr << fmt::format("\r{:<60}\r", "");
#ifndef PCM_WITH_DYNAMICS
  std::cerr << "A12 to A17 are left out: this program was built without SUNDIALS\n";
#endif
  if (folder) write_tables(*folder, report);
  std::cout << known_answers_summary(report) << fmt::format("identities: seed {}\n", seed)
            << known_answers_verdict(report) << '\n';
  return report.met() ? Exit::success : Exit::negative;
}

}  // namespace pcm::compare
