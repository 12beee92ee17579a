// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "bindings/python/rows.h"
#include "pcm/engine.h"

namespace pcm::python {

/// Workspaces that are not in use, so that one caller after the other has grown memory, and each thread one of its own.
class WorkspacePool {
 public:
  std::unique_ptr<fast::Workspace> take();
  void give_back(std::unique_ptr<fast::Workspace> workspace);

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<fast::Workspace>> free_;
};

/// States one after the other, each of 9 numbers of A by rows and 3 of r, v and w; v and w may be null, for 0.
struct States {
  std::size_t count = 0;
  const double* A = nullptr;
  const double* r = nullptr;
  const double* v = nullptr;
  const double* w = nullptr;

  Pose pose(std::size_t i) const;
  Velocity velocity(std::size_t i) const;
};

/// Evaluates all states, `threads` at once, at least 1, and writes a row for each; the rows don't depend on the number
/// of threads. Throws BadInput for the first state that is bad, naming its number from 0. Needs no Python.
void evaluate_many(const fast::Pairing& pairing, const States& states, const Wanted& wanted, int threads,
                   WorkspacePool& workspaces, AnswerRow* rows);

}  // namespace pcm::python
