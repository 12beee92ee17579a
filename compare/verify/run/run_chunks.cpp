// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/run_chunks.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace pcm::compare {
namespace {

/// What is done is handed in about this often: it is lost where the process is killed.
constexpr std::chrono::milliseconds kHandIn{500};
/// Chunks claimed together where they take less time; no more than one where a single one takes longer.
constexpr std::int64_t kMostChunks = 128;

class ChunksInMemory : public Chunks<Outcomes> {
 public:
  explicit ChunksInMemory(Verification& run) : run_(run) {}

  std::optional<ChunkRange> claim(std::int64_t most) override {
    const std::lock_guard lock(mutex_);
    if (next_ == run_.chunks()) return std::nullopt;
    const std::int64_t first = std::exchange(next_, std::min(next_ + most, run_.chunks()));
    return ChunkRange{first, next_};
  }
  void commit(ChunkRange, Outcomes outcomes) override {
    const std::lock_guard lock(mutex_);
    run_.add(std::move(outcomes));
  }
  void give_back(ChunkRange) override {}

 private:
  std::mutex mutex_;
  Verification& run_;
  std::int64_t next_ = 0;
};

}  // namespace

void run_chunks(const Verification& run, Chunks<Outcomes>& chunks, int jobs, const std::function<bool()>& stop,
                const std::function<void(std::int64_t)>& progress) {
  std::atomic<std::int64_t> done = 0;
  std::atomic<bool> failed = false;
  std::exception_ptr failure;
  std::mutex reporting;
  const auto goes_on = [&](std::int64_t more) {
    const std::int64_t now = done += more;
    if (more > 0)
      if (const std::unique_lock lock(reporting, std::try_to_lock); lock) progress(now);
    return !failed && !stop();
  };
  const auto hold_some = [&] {
    fast::Workspace workspace;
    std::int64_t most = 1;
    while (!failed && !stop()) {
      const std::optional<ChunkRange> claimed = chunks.claim(most);
      if (!claimed) return;
      const auto begun = std::chrono::steady_clock::now();
      Outcomes all;
      for (std::int64_t chunk = claimed->first; chunk < claimed->end; ++chunk) {
        std::optional<Outcomes> outcomes = run.hold_chunk(chunk, workspace, goes_on);
        if (!outcomes) return chunks.give_back(*claimed);
        all.merge(std::move(*outcomes));
      }
      chunks.commit(*claimed, std::move(all));
      const auto took = std::chrono::steady_clock::now() - begun;
      most = took < kHandIn / 2 ? std::min(2 * most, kMostChunks)
             : took > kHandIn   ? std::max<std::int64_t>(1, most / 2)
                                : most;
    }
  };
  std::vector<std::jthread> threads;
  for (int k = 0; k < jobs; ++k)
    threads.emplace_back([&] {
      try {
        hold_some();
      } catch (...) {
        const std::lock_guard lock(reporting);
        if (!failure) failure = std::current_exception();
        failed = true;
      }
    });
  threads.clear();
  if (failure) std::rethrow_exception(failure);
}

void run_all(Verification& run, int jobs, const std::function<bool()>& stop,
             const std::function<void(std::int64_t)>& progress) {
  ChunksInMemory chunks(run);
  run_chunks(run, chunks, jobs, stop, progress);
}

}  // namespace pcm::compare
