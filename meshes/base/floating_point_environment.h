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
/// A host may have any environment, and gets the same answer, where it calls
/// - the engine: `fast::Surface`, `Pairing`, `PairingMemory`, `evaluate`, `Scene`, `layer_stiffness`, and threads;
/// - surfaces: `read_mesh`, `read_obj`, `read_off`, `parse_obj`, `parse_off`, `parse_number`, `make` and `check`;
/// - the oracle: `reference::Oracle`, `Inquiry`, `prove_identities` and `self_intersections`.
/// Each of these holds one, or computes nothing beside what it calls. What they are built of holds none, as
/// fast/force/law_parameters.h and the generators that `make` calls (`generate::`, `degenerate::`), which give the
/// promised bits in the default environment only. Nor does what writes surfaces, or compare/.
///
/// On x86-64 it looks at MXCSR alone, as the engine does not use the x87 unit (the C library asks that how to round the
/// last digit of a number in a message), and writes only what differs: two reads where nothing does. A compiler knows
/// nothing of all this, so who holds one computes with what is in memory, or in functions that are not inlined.
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
