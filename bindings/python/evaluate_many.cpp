// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings/python/evaluate_many.h"

#include <algorithm>
#include <exception>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "bindings/c/inputs.h"
#include "pcm/bad_input.h"

namespace pcm::python {

std::unique_ptr<fast::Workspace> WorkspacePool::take() {
  const std::lock_guard lock(mutex_);
  if (free_.empty()) return std::make_unique<fast::Workspace>();
  std::unique_ptr<fast::Workspace> workspace = std::move(free_.back());
  free_.pop_back();
  return workspace;
}

void WorkspacePool::give_back(std::unique_ptr<fast::Workspace> workspace) {
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(workspace));
}

Pose States::pose(std::size_t i) const {
  return c::pose_from(A + 9 * i, r + 3 * i);
}

Velocity States::velocity(std::size_t i) const {
  return c::velocity_from(v == nullptr ? v : v + 3 * i, w == nullptr ? w : w + 3 * i);
}

namespace {

/// States `begin` to `end`; stops at the first bad one.
void evaluate_range(const fast::Pairing& pairing, const States& states, std::size_t begin, std::size_t end,
                    const Wanted& wanted, fast::Workspace& workspace, AnswerRow* rows) {
  for (std::size_t i = begin; i < end; ++i) {
    try {
      rows[i] = row_of(fast::evaluate(pairing, states.pose(i), states.velocity(i), wanted, workspace));
    } catch (const BadInput& bad) {
      throw BadInput(std::string("pose ") + std::to_string(i) + ": " + bad.what());
    }
  }
}

}  // namespace

void evaluate_many(const fast::Pairing& pairing, const States& states, const Wanted& wanted, int threads,
                   WorkspacePool& workspaces, AnswerRow* rows) {
  if (threads < 1) throw BadInput(std::string("threads is ") + std::to_string(threads) + "; it must be at least 1");
  const std::size_t parts =
      std::min<std::size_t>(static_cast<std::size_t>(threads), std::max<std::size_t>(states.count, 1));
  std::vector<std::exception_ptr> failures(parts);
  const auto evaluate_part = [&](std::size_t part) {
    try {
      std::unique_ptr<fast::Workspace> workspace = workspaces.take();
      evaluate_range(pairing, states, states.count * part / parts, states.count * (part + 1) / parts, wanted,
                     *workspace, rows);
      workspaces.give_back(std::move(workspace));
    } catch (...) {
      failures[part] = std::current_exception();
    }
  };
  std::vector<std::jthread> others;
  others.reserve(parts - 1);
  try {
    while (others.size() + 1 < parts) others.emplace_back(evaluate_part, others.size() + 1);
  } catch (const std::system_error&) {
    // The system has no more threads: what is left is done by this one.
  }
  for (std::size_t part = others.size() + 1; part < parts; ++part) evaluate_part(part);
  evaluate_part(0);
  others.clear();  // waits for them
  // Parts lie in the order of the states, so the first failure is that of the first bad one.
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace pcm::python
