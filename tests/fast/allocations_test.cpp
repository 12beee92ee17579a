// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/fast/engine_support.h"

namespace {
std::atomic<long> allocations{0};
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace pcm::fast {
namespace {

void expect_no_allocation_once_grown(Scheme scheme) {
  const Surface bubble(generate::bubble());
  ContactLaw law;
  law.friction = 0.5;
  const Pairing closed(bubble, bubble, law, Mode::both, scheme);
  const Pairing open(Surface(generate::pyramid()), bubble, law, Mode::both, scheme);
  Workspace workspace;
  Wanted bounded;
  bounded.bound = true;
  const auto run = [&] {
    for (int i = 0; i < 20; ++i) {
      const Pose deep = test::turned(0.3 * i, {0.05, 0.1, 0.12});
      EXPECT_TRUE(evaluate(closed, deep, {}, {}, workspace).touching);
      EXPECT_TRUE(evaluate(open, test::turned(0.3 * i, {0.01, 0.02, 0.05}), {}, {}, workspace).touching);
      EXPECT_TRUE(evaluate(closed, deep, {}, bounded, workspace).bound.has_value());
    }
    EXPECT_TRUE(evaluate(closed, {}, {}, bounded, workspace).bound->flipped);
  };
  run();
  const long before = allocations;
  EXPECT_GT(before, 0);
  run();
  EXPECT_EQ(allocations - before, 0);
}

TEST(Allocations, NoneOnceTheWorkspaceHasGrown) {
  expect_no_allocation_once_grown(Scheme::barycentric);
}

TEST(Allocations, NoneInTheClippedSchemeOnceTheWorkspaceHasGrown) {
  expect_no_allocation_once_grown(Scheme::clipped);
}

}  // namespace
}  // namespace pcm::fast
