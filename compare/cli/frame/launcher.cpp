// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/launcher.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace pcm::compare {
namespace {

std::optional<int> number_in(const char* variable) {
  const char* const value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): before any thread is started
  if (value == nullptr) return std::nullopt;
  const std::string_view text(value);
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

struct Variables {
  const char *rank, *processes, *on_this_machine;
};

constexpr std::array kLaunchers = {
    Variables{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_LOCAL_SIZE"},
    Variables{"PMI_RANK", "PMI_SIZE", "MPI_LOCALNRANKS"},
    Variables{"SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "SLURM_STEP_TASKS_PER_NODE"},
};

}  // namespace

LaunchedProcess launched_process() {
  for (const Variables& launcher : kLaunchers) {
    const std::optional<int> rank = number_in(launcher.rank), processes = number_in(launcher.processes);
    if (!rank || !processes || *rank < 0 || *rank >= *processes) continue;
    return {*rank, *processes, std::max(1, number_in(launcher.on_this_machine).value_or(*processes))};
  }
  return {};
}

}  // namespace pcm::compare
