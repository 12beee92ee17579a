// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "compare/campaign/campaign.h"

namespace pcm::compare {

/// What is done is handed in about this often, and no more often than this many times what handing in takes: it is lost
/// where the process is killed.
inline constexpr std::chrono::milliseconds kHandIn{500};
inline constexpr int kWorkPerHandIn = 50;
/// Chunks claimed together where they take less time; no more than one where a single one takes longer.
inline constexpr std::int64_t kMostChunks = 1024;

/// What a thread does to a chunk; none where it was interrupted.
template <class Result>
using DoChunk = std::function<std::optional<Result>(std::int64_t chunk)>;

/// Does chunks on `jobs` threads until none is to be had or `stop` says so. Each thread has what `worker` makes for it.
/// What is thrown ends it, after what the other threads are at. Result has `merge(Result&&)`.
template <class Result>
void run_chunks(Chunks<Result>& chunks, int jobs, const std::function<bool()>& stop,
                const std::function<DoChunk<Result>()>& worker) {
  std::atomic<bool> failed = false;
  std::exception_ptr failure;
  std::mutex failing;
  const auto do_some = [&] {
    const DoChunk<Result> do_chunk = worker();
    std::int64_t most = 1;
    while (!failed && !stop()) {
      const std::optional<ChunkRange> claimed = chunks.claim(most);
      if (!claimed) return;
      const auto begun = std::chrono::steady_clock::now();
      Result all;
      for (std::int64_t chunk = claimed->first; chunk < claimed->end; ++chunk) {
        std::optional<Result> result;
        if (!failed) result = do_chunk(chunk);
        if (!result) return chunks.give_back(*claimed);
        all.merge(std::move(*result));
      }
      const auto done = std::chrono::steady_clock::now();
      chunks.commit(*claimed, std::move(all));
      const auto handed_in = std::chrono::steady_clock::now();
      const auto interval = std::max<std::chrono::nanoseconds>(kHandIn, kWorkPerHandIn * (handed_in - done));
      const std::int64_t number = claimed->end - claimed->first;
      if (handed_in - begun < interval / 2) most = std::min(std::max(most, 2 * number), kMostChunks);
      if (handed_in - begun > interval) most = std::max<std::int64_t>(1, number / 2);
    }
  };
  std::vector<std::jthread> threads;
  for (int k = 0; k < jobs; ++k)
    threads.emplace_back([&] {
      try {
        do_some();
      } catch (...) {
        const std::lock_guard lock(failing);
        if (!failure) failure = std::current_exception();
        failed = true;
      }
    });
  threads.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace pcm::compare
