// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>
#include <sstream>

#include "meshes/generate/parts.h"
#include "pcm/pairing_memory.h"
#include "pcm/scene.h"
#include "tests/fast/engine_support.h"
#include "tests/fast/same_answer.h"

namespace {
std::atomic<long> allocations{0};
std::atomic<std::size_t> greatest_allocation{0};
std::atomic<long> allocations_left{std::numeric_limits<long>::max()};

/// Counts an allocation, or throws where memory is said to have ended.
void allocate_one() {
  ++allocations;
  if (--allocations_left < 0) throw std::bad_alloc();
}
}  // namespace

// Not inlined: gcc would see a pointer that came of `new` go to `free`, and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocate_one();
  std::size_t greatest = greatest_allocation;
  while (size > greatest && !greatest_allocation.compare_exchange_weak(greatest, size)) {
  }
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  allocate_one();
  const auto unit = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(unit, (size + unit - 1) / unit * unit)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
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
  law.max_penetration = 0.03125;
  const Pairing clamped(bubble, bubble, law, Mode::both, scheme);
  Workspace workspace;
  Wanted bounded;
  bounded.bound = true;
  Wanted with_tangent;
  with_tangent.tangent = true;
  Wanted only_touch;
  only_touch.polygons = only_touch.areas = only_touch.force = only_touch.elements = false;
  const auto run = [&] {
    for (int i = 0; i < 20; ++i) {
      const Pose deep = test::turned(0.3 * i, {0.05, 0.1, 0.12});
      EXPECT_TRUE(evaluate(closed, deep, {}, {}, workspace).touching);
      EXPECT_TRUE(evaluate(open, test::turned(0.3 * i, {0.01, 0.02, 0.05}), {}, {}, workspace).touching);
      EXPECT_TRUE(evaluate(closed, deep, {}, only_touch, workspace).touching);
      EXPECT_TRUE(evaluate(closed, deep, {}, bounded, workspace).bound.has_value());
      EXPECT_TRUE(evaluate(closed, deep, {}, with_tangent, workspace).tangent.has_value());
      EXPECT_TRUE(evaluate(clamped, deep, {}, bounded, workspace).penetration_exceeded);
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

TEST(Allocations, NoneInAMemoryThatHasGrown) {
  const Surface bubble(generate::bubble());
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    PairingMemory memory(Pairing(bubble, bubble, test::stiffness(1), Mode::both, scheme));
    Workspace workspace;
    const auto run = [&] {
      for (int i = 0; i < 20; ++i) {
        const Pose deep = test::turned(0.3 * i, {0.05, 0.1, 0.12});
        for (int k = 0; k < 3; ++k) {
          const Contact& contact = memory.evaluate(deep, {{0.1 * k, 0, 0}, {0, 0, 0}}, {}, workspace);
          EXPECT_TRUE(contact.touching);
          EXPECT_EQ(contact.work.law_only, k > 0);
        }
      }
    };
    // Lists change places between workspace and memory, so that two of each have to grow.
    run();
    run();
    const long before = allocations;
    run();
    EXPECT_EQ(allocations - before, 0);
  }
}

TEST(Allocations, NoneWhereSurfacesMeetFacesForTheFirstTime) {
  for (const TriangleMesh& mesh : {generate::bubble(), generate::spur_gear(20, 0.1, 0.5, 4, 2)}) {
    const Surface surface(mesh);
    const long before = allocations;
    surface.prepare_all_faces();
    EXPECT_EQ(allocations - before, 0);
  }
}

TEST(Allocations, NoneInASceneThatHasSeenItsContacts) {
  const Surface bubble(generate::bubble());
  Scene scene;
  for (int b = 0; b < 3; ++b) scene.add_body(bubble);
  for (Index F = 1; F < 3; ++F) scene.add_pairing(0, F);
  std::vector<BodyState> states(3);
  const auto run = [&] {
    for (int i = 0; i < 10; ++i) {
      states[1].pose = test::turned(0.3 * i, {0.05, 0.1, 0.12});
      states[2].pose = test::turned(0.2 * i, {0, 0.1 * i, 0.3});
      scene.move(states);
      scene.evaluate_all();
    }
  };
  run();
  const long before = allocations;
  run();
  EXPECT_EQ(allocations - before, 0);
}

/// Wherever memory ends while poses are followed, what is known from then on is true.
TEST(Allocations, WhereMemoryEndsWhatIsFollowedStaysTrue) {
  const Surface bubble(generate::bubble());
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    const Pairing pairing(bubble, bubble, test::stiffness(1), Mode::both, scheme);
    Workspace plain;
    const auto pose = [](int i) { return test::turned(0.3 + 1e-6 * i, {0.05, 0.1, 0.12 + 2e-6 * i}); };
    int failures = 0;
    bool failed = true;
    for (int number = 0; failed; ++number) {
      SCOPED_TRACE(number);
      PairingMemory memory(pairing);
      Workspace workspace;
      failed = false;
      int next = 0;
      allocations_left = number;
      try {
        for (; next < 4; ++next) memory.evaluate(pose(next), {}, {}, workspace);
      } catch (const std::bad_alloc&) {
        failed = true;
        ++failures;
      }
      allocations_left = std::numeric_limits<long>::max();
      for (int i = next; i < next + 3; ++i) {
        test::expect_same_answer(memory.evaluate(pose(i), {}, {}, workspace),
                                 evaluate(pairing, pose(i), {}, {}, plain));
      }
    }
    EXPECT_GT(failures, 100);
  }
}

TEST(Allocations, SliversOfRoundingSizeDoNotMultiplyThePartsOfAFace) {
  // The flanks of a gear are parallel to its axis: along a cap's penetration lines they are seen edgewise, or, where
  // rounding has moved vertices, as slivers as long as a tooth, four of them along one line. A face has at most a few
  // parts for each of the other gear's 1200 faces, here less than one.
  const Surface gear(generate::spur_gear(20, 0.1, 0.5, 4, 2));
  constexpr std::size_t kPart = 400;  // bytes of a convex polygon
  Workspace workspace;
  const Pairing pairing(gear, gear, test::stiffness(1), Mode::both, Scheme::clipped);
  for (int i = 0; i < 6; ++i) {
    const Pose pose = test::turned(1 + 0.37 * i, {0.6 - 0.1 * i, 0.3, 0.2});
    std::ostringstream text;
    text << "A\n" << pose.A << "\nr " << pose.r.transpose();
    SCOPED_TRACE(text.str());
    greatest_allocation = 0;
    const Contact& contact = evaluate(pairing, pose, {}, Wanted{false, false, true, false}, workspace);
    EXPECT_TRUE(contact.touching);
    EXPECT_GT(contact.force_Me.norm(), 0);
    EXPECT_LT(greatest_allocation, 1200 * kPart);
  }
}

}  // namespace
}  // namespace pcm::fast
