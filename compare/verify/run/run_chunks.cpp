// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/run/run_chunks.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <utility>

#include "compare/campaign/run_chunks.h"

namespace pcm::compare {
namespace {

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
  std::mutex reporting;
  const auto goes_on = [&](std::int64_t more) {
    const std::int64_t now = done += more;
    if (more > 0)
      if (const std::unique_lock lock(reporting, std::try_to_lock); lock) progress(now);
    return !stop();
  };
  run_chunks<Outcomes>(chunks, jobs, stop, [&]() -> DoChunk<Outcomes> {
    return [&run, &goes_on, workspace = std::make_shared<fast::Workspace>()](std::int64_t chunk) {
      return run.hold_chunk(chunk, *workspace, goes_on);
    };
  });
}

void run_all(Verification& run, int jobs, const std::function<bool()>& stop,
             const std::function<void(std::int64_t)>& progress) {
  ChunksInMemory chunks(run);
  run_chunks(run, chunks, jobs, stop, progress);
}

}  // namespace pcm::compare
