// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_audits.h"

#include <fmt/core.h>
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "compare/cli/verify/kept_folder.h"
#include "compare/io/tables/report_folder.h"
#include "compare/motion/audits_report.h"

namespace pcm::compare {

Exit verify_audits(Extent extent, int jobs, const std::optional<std::filesystem::path>& folder) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  KeptValues kept = kept_values(folder, "audits", extent);
  const std::vector<AuditResult> results = run_audits(extent, jobs, kept, [&](std::size_t done, std::size_t all) {
    if (terminal) std::cerr << fmt::format("\r{} of {} loops", done, all) << std::flush;
  });
  if (terminal) std::cerr << fmt::format("\r{:<40}\r", "");
  std::cout << audits_summary(results) << audits_verdict(results) << '\n';
  if (folder) {
    ReportFolder report(*folder, "audits",
                        {{"steps", extent == Extent::quick ? "quick" : "full"},
                         {"laws", "elastic, of each case its own (docs/energy_and_jumps.md)"}});
    report.markdown("audits", audits_markdown(results));
    report.csv("audits", audits_csv(results), audits_units());
    report.json("audits", audits_json(results));
    report.finish();
    kept.finish();
  }
  return met(results) ? Exit::success : Exit::negative;
}

}  // namespace pcm::compare
