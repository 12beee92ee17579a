// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <vector>

#include "fast/base/shares.h"
#include "fast/base/thread_team.h"
#include "fast/posed/posed_pair.h"

namespace pcm::fast {

/// The threads that may take part in an evaluation, the caller's among them. Each has a posed pair of its own, since
/// vertices of F are transformed when they are first asked for; what they read there is the same, bit for bit.
class PosedTeam {
 public:
  explicit PosedTeam(std::size_t threads) : others_(threads - 1) {}

  std::size_t threads() const { return others_.size() + 1; }

  /// To be called once a pose.
  void start() {
    for (Other& other : others_) other.placed = false;
  }

  using Task = std::function<void(std::size_t thread, PosedPair& posed)>;
  /// Calls task(thread, pair) in as many of the threads at the same time, at most all: thread 0 is the caller's, with
  /// `posed`, to which the work of all is added; each in the default floating-point environment. Returns when all are
  /// done; what was thrown by the first of them is thrown on.
  void run(std::size_t threads, PosedPair& posed, const Task& task);

 private:
  struct alignas(kApart) Other {
    PosedPair posed;
    bool placed = false;
    std::exception_ptr failure;
  };

  ThreadTeam team_;
  std::vector<Other> others_;
};

}  // namespace pcm::fast
