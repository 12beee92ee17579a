// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/posed/posed_team.h"

#include <utility>

#include "meshes/base/floating_point_environment.h"

namespace pcm::fast {

void PosedTeam::run(std::size_t threads, PosedPair& posed, const Task& task) {
  std::exception_ptr failure;
  const auto take_part = [&](std::size_t thread) {
    std::exception_ptr& own_failure = thread == 0 ? failure : others_[thread - 1].failure;
    try {
      if (thread == 0) {
        task(0, posed);
        return;
      }
      const DefaultFloatingPoint environment;
      Other& own = others_[thread - 1];
      if (!own.placed) own.posed.place_like(posed);
      own.placed = true;
      task(thread, own.posed);
    } catch (...) {
      own_failure = std::current_exception();
    }
  };
  // By reference, so that no copy is allocated.
  team_.run(threads, std::cref(take_part));
  for (std::size_t thread = 1; thread < threads; ++thread) {
    Other& other = others_[thread - 1];
    posed.work += std::exchange(other.posed.work, {});
    if (const std::exception_ptr own = std::exchange(other.failure, nullptr); !failure) failure = own;
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace pcm::fast
