// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/base/floating_point_environment.h"

#include <atomic>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace pcm {

// The fences keep what is in memory from being read or written on the other side.
#if defined(__SSE2__)

namespace {

/// All exceptions masked and none raised, rounding to nearest, denormals kept.
constexpr unsigned kDefault = 0x1f80;
constexpr unsigned kRaised = 0x3f;

}  // namespace

DefaultFloatingPoint::DefaultFloatingPoint() : callers_(_mm_getcsr()) {
  if ((callers_ & ~kRaised) != kDefault) _mm_setcsr(kDefault);
  std::atomic_signal_fence(std::memory_order_seq_cst);
}

DefaultFloatingPoint::~DefaultFloatingPoint() {
  std::atomic_signal_fence(std::memory_order_seq_cst);
  if (_mm_getcsr() != callers_) _mm_setcsr(callers_);
}

#else

DefaultFloatingPoint::DefaultFloatingPoint() {
  std::fegetenv(&callers_);
  std::fesetenv(FE_DFL_ENV);
  std::atomic_signal_fence(std::memory_order_seq_cst);
}

DefaultFloatingPoint::~DefaultFloatingPoint() {
  std::atomic_signal_fence(std::memory_order_seq_cst);
  std::fesetenv(&callers_);
}

#endif

}  // namespace pcm
