// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/base/thread_team.h"

namespace pcm::fast {

ThreadTeam::~ThreadTeam() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
  }
  start_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadTeam::run(std::size_t members, const std::function<void(std::size_t)>& task) {
  if (members == 0) return;
  {
    const std::lock_guard lock(mutex_);
    while (threads_.size() + 1 < members) {
      threads_.emplace_back([this, member = threads_.size() + 1, seen = round_] { work(member, seen); });
    }
    task_ = &task;
    members_ = members;
    ++round_;
    busy_ = threads_.size();
  }
  start_.notify_all();
  task(0);
  std::unique_lock lock(mutex_);
  end_.wait(lock, [&] { return busy_ == 0; });
}

void ThreadTeam::work(std::size_t member, std::size_t rounds_seen) {
  std::unique_lock lock(mutex_);
  for (;;) {
    start_.wait(lock, [&] { return leaving_ || round_ != rounds_seen; });
    if (leaving_) return;
    rounds_seen = round_;
    if (member < members_) {
      const std::function<void(std::size_t)>& task = *task_;
      lock.unlock();
      task(member);
      lock.lock();
    }
    if (--busy_ == 0) end_.notify_one();
  }
}

}  // namespace pcm::fast
