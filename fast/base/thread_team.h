// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace pcm::fast {

/// Threads that wait for work between calls, so that a step of a simulation starts none.
class ThreadTeam {
 public:
  ThreadTeam() = default;
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Runs task(0) to task(members - 1) at the same time, member 0 in the caller's thread, and returns when all are
  /// done. The task must not throw. Threads that are missing are started, and then kept; throws std::system_error where
  /// the system has none left, before anything is run.
  void run(std::size_t members, const std::function<void(std::size_t member)>& task);

 private:
  void work(std::size_t member, std::size_t rounds_seen);

  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable start_, end_;
  const std::function<void(std::size_t)>* task_ = nullptr;
  std::size_t members_ = 0;  ///< of the round at hand
  std::size_t busy_ = 0;     ///< threads that have not ended their round
  std::size_t round_ = 0;
  bool leaving_ = false;
};

}  // namespace pcm::fast
