// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "pcm/triangle_mesh.h"

namespace pcm::fast {

/// A value for each of some items, computed when it is first asked for. Any number of threads may ask at once, and none
/// of them waits: two that find an item unknown compute it both, so whatever computes must give the same value each
/// time.
template <class Value>
class OnDemand {
  static_assert(std::is_trivially_copyable_v<Value>, "a copy that throws would leave its item unknown for good");

 public:
  OnDemand() = default;
  explicit OnDemand(std::size_t items) : items_(std::make_unique<Item[]>(items)) {}

  /// The item's value, which compute() returns where it is not known yet.
  template <class Compute>
  Value get(Index item, const Compute& compute) const {
    Item& known = items_[static_cast<std::size_t>(item)];
    if (known.state.load(std::memory_order_acquire) == State::known) return known.value;
    const Value value = compute();
    State expected = State::unknown;
    if (known.state.compare_exchange_strong(expected, State::being_written, std::memory_order_relaxed)) {
      known.value = value;
      known.state.store(State::known, std::memory_order_release);
    }
    return value;
  }

 private:
  enum class State : std::uint8_t { unknown, being_written, known };
  struct Item {
    Value value{};
    std::atomic<State> state{State::unknown};
  };
  std::unique_ptr<Item[]> items_;
};

}  // namespace pcm::fast
