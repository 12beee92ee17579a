// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace pcm::fast {

/// What different threads write to is so far apart, bytes, that no processor fetches both at once.
inline constexpr std::size_t kApart = 128;

/// Items 0 to count - 1, which threads take a few at a time, whoever is free.
class Shares {
 public:
  struct Share {
    std::size_t number;      ///< of the share, from 0
    std::size_t begin, end;  ///< items; none where all are taken

    bool empty() const { return begin == end; }
  };

  Shares(std::size_t count, std::size_t items_at_once) : count_(count), at_once_(items_at_once) {}

  std::size_t shares() const { return (count_ + at_once_ - 1) / at_once_; }
  Share take() {
    const std::size_t number = next_.fetch_add(1, std::memory_order_relaxed);
    const std::size_t begin = std::min(number * at_once_, count_);
    return {number, begin, std::min(begin + at_once_, count_)};
  }

 private:
  std::size_t count_, at_once_;
  std::atomic<std::size_t> next_{0};
};

}  // namespace pcm::fast
