// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/verify/verify_audits.h"

#include <fmt/core.h>
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "compare/motion/audits_report.h"
#include "meshes/files/text_file.h"

namespace pcm::compare {

Exit verify_audits(Extent extent, int jobs, const std::optional<std::filesystem::path>& folder) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const std::vector<AuditResult> results = run_audits(extent, jobs, [&](std::size_t done, std::size_t all) {
    if (terminal) std::cerr << fmt::format("\r{} of {} loops", done, all) << std::flush;
  });
  if (terminal) std::cerr << fmt::format("\r{:<40}\r", "");
  if (folder) {
    write_text_file(*folder / "audits.md", audits_markdown(results));
    write_text_file(*folder / "audits.csv", audits_csv(results));
    write_text_file(*folder / "audits.json", audits_json(results).dump(1) + "\n");
  }
  std::cout << audits_summary(results) << audits_verdict(results) << '\n';
  return met(results) ? Exit::success : Exit::negative;
}

}  // namespace pcm::compare
