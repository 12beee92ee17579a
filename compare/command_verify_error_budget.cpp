// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/command_verify_error_budget.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <string>
#include <vector>

#include "compare/error_budget.h"
#include "meshes/text_file.h"

namespace pcm::compare {

Exit verify_error_budget(Extent extent, int jobs, const std::optional<std::filesystem::path>& folder) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const std::vector<ErrorBudget> budgets = error_budgets(extent, jobs, [&](const std::string& what) {
    if (terminal) std::cerr << fmt::format("\r{:<60}", what) << std::flush;
  });
  if (terminal) std::cerr << fmt::format("\r{:<60}\r", "");
  if (folder) write_text_file(*folder / "error_budget.md", error_budget_markdown(budgets));
  std::cout << error_budget_summary(budgets);
  return Exit::success;
}

}  // namespace pcm::compare
