// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if !defined(__SSE2__)
#include <cfenv>
#endif

namespace pcm {

/// The floating-point environment that bits and signs are promised in, for the calling thread and as long as this
/// lives: rounding to nearest, denormals neither flushed to zero nor taken for it, no traps. Afterwards the caller's is
/// back as it was, sticky exception flags included: what is raised meanwhile leaves no trace.
///
/// Every public function of the engine that computes holds one, and those that read, make and check surfaces, so that a
/// host may have any environment; so does each thread that the engine runs. On x86-64 it looks at MXCSR alone, as the
/// engine does not use the x87 unit (the C library asks that how to round the last digit of a number in a message), and
/// writes only what differs: two reads where nothing does. A compiler knows nothing of all this, so who holds one
/// computes with what is in memory, or in functions that are not inlined.
class DefaultFloatingPoint {
 public:
  DefaultFloatingPoint();
  ~DefaultFloatingPoint();
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

 private:
#if defined(__SSE2__)
  unsigned callers_;
#else
  std::fenv_t callers_;
#endif
};

}  // namespace pcm
