// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace pcm::compare {

/// Which of the processes that mpirun or srun has started together this one is. Nothing else of MPI is needed: they
/// share a folder.
struct LaunchedProcess {
  int rank = 0;
  int processes = 1;
  int on_this_machine = 1;
  /// A name that all of them share, and no others; those on one machine only, where the launcher gives none.
  std::string launch;
};

/// Whether this process leaves it to another one of its launch to print what came of their common work: one speaks for
/// all, the one that finishes it, or else the first (or both, where their launch has two names). `finished_by`: the
/// launch that finished it, if any has; `done`: it can be finished. mpirun ends all processes when one fails: so
/// whoever is silent has succeeded.
bool is_silent(const LaunchedProcess& process, bool done, const std::optional<std::string>& finished_by);

/// How many threads this process is to have: as many as cores that it may run on, or its part of the machine's.
int cores_of(const LaunchedProcess& process);

/// As the environment says that Open MPI, MPICH and Slurm give; one of one where it says nothing.
LaunchedProcess launched_process();

}  // namespace pcm::compare
