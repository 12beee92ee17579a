// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/base/on_demand.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <thread>
#include <vector>

namespace pcm::fast {
namespace {

/// Large enough that a thread which read it half written would see it.
using Value = std::array<Index, 16>;

Value value_of(Index item) {
  Value value;
  value.fill(item);
  return value;
}

TEST(OnDemand, ComputesAnItemWhenItIsFirstAskedForAndNeverAgain) {
  const OnDemand<Value> values(3);
  int computed = 0;
  const auto get = [&](Index item) {
    return values.get(item, [&] {
      ++computed;
      return value_of(item);
    });
  };
  EXPECT_EQ(get(2), value_of(2));
  EXPECT_EQ(computed, 1);
  EXPECT_EQ(get(2), value_of(2));
  EXPECT_EQ(computed, 1);
  EXPECT_EQ(get(0), value_of(0));
  EXPECT_EQ(computed, 2);
}

TEST(OnDemand, ThreadsThatAskAtOnceAllGetTheWholeValue) {
  constexpr Index kItems = 20000;
  constexpr Index kThreads = 4;
  const OnDemand<Value> values(kItems);
  std::atomic<Index> arrived{0}, wrong{0}, computed{0};
  std::vector<std::thread> threads;
  for (Index t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      ++arrived;
      while (arrived < kThreads) std::this_thread::yield();
      for (Index i = 0; i < kItems; ++i) {
        // Two go forwards together, two backwards.
        const Index item = t % 2 == 0 ? i : kItems - 1 - i;
        const Value value = values.get(item, [&] {
          ++computed;
          return value_of(item);
        });
        if (value != value_of(item)) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(computed, kItems);
  for (Index i = 0; i < kItems; ++i) {
    const Value value = values.get(i, [&] {
      ++wrong;  // all are known
      return Value{};
    });
    if (value != value_of(i)) ++wrong;
  }
  EXPECT_EQ(wrong, 0);
}

TEST(OnDemand, AnItemThatThrowsIsAskedForAnew) {
  const OnDemand<int> values(1);
  EXPECT_THROW(values.get(0, []() -> int { throw 1; }), int);
  EXPECT_EQ(values.get(0, [] { return 7; }), 7);
}

}  // namespace
}  // namespace pcm::fast
