// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cli/frame/launcher.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

#include "compare/io/provenance/this_host.h"

namespace pcm::compare {
namespace {

std::string value_of(const char* variable) {
  const char* const value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): before any thread is started
  return value == nullptr ? "" : value;
}

/// That the value begins with, as in "4(x2)".
std::optional<int> number_in(const char* variable) {
  const std::string text = value_of(variable);
  int number = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), number).ec != std::errc()) return std::nullopt;
  return number;
}

struct Variables {
  const char *rank, *processes, *on_this_machine, *launch;
};

// MPICH 4.0 gives its processes no name in common; PMIx does.
constexpr std::array kLaunchers = {
    Variables{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_LOCAL_SIZE", "OMPI_MCA_ess_base_jobid"},
    Variables{"PMI_RANK", "PMI_SIZE", "MPI_LOCALNRANKS", "PMIX_NAMESPACE"},
    Variables{"SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "SLURM_STEP_TASKS_PER_NODE", "SLURM_JOB_ID"},
};

/// The process that started this one, told from all others that had its number on this machine or another one.
std::string parent_process() {
  const std::string number = std::to_string(getppid());
  std::ifstream file("/proc/" + number + "/stat");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  // Its start is the 20th word behind its name in brackets, which may have blanks and brackets in it (proc(5)).
  std::istringstream words(text.substr(text.rfind(')') + 1));
  std::string started;
  for (int word = 0; word < 20; ++word) words >> started;
  return this_host() + ' ' + number + ' ' + started;
}

/// What the launcher calls its launch; without a name who started this process, which is one for all on one machine.
std::string name_of_launch(const Variables& launcher) {
  const std::string name = value_of(launcher.launch);
  if (name.empty()) return parent_process();
  return std::string(launcher.launch) + '=' + name + '.' + value_of("SLURM_STEP_ID");
}

}  // namespace

LaunchedProcess launched_process() {
  for (const Variables& launcher : kLaunchers) {
    const std::optional<int> rank = number_in(launcher.rank), processes = number_in(launcher.processes);
    if (!rank || !processes || *rank < 0 || *rank >= *processes) continue;
    return {*rank, *processes, std::max(1, number_in(launcher.on_this_machine).value_or(*processes)),
            name_of_launch(launcher)};
  }
  return {};
}

bool is_silent(const LaunchedProcess& process, bool done, const std::optional<std::string>& finished_by) {
  if (process.processes == 1) return false;
  if (finished_by) return *finished_by == process.launch || process.rank > 0;
  return !done && process.rank > 0;
}

int cores_of(const LaunchedProcess& process) {
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  cpu_set_t own;
  CPU_ZERO(&own);
  // mpirun and srun may have given each process cores of its own.
  if (sched_getaffinity(0, sizeof own, &own) == 0 && CPU_COUNT(&own) < all) return std::max(1, CPU_COUNT(&own));
  return std::max(1, all / process.on_this_machine);
}

}  // namespace pcm::compare
