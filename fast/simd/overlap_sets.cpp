// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/simd/overlap_sets.h"

#include "fast/simd/instruction_set.h"
#include "fast/simd/overlap_kernels.h"

namespace pcm::fast {

extern const WideTests kWideTestsAvx2;  // where kWithAvx2

std::array<const WideTests*, 2> all_wide_tests() {
  if constexpr (kWithAvx2) {
    return runnable_sets(kTests, kWideTestsAvx2);
  } else {
    return {&kTests, nullptr};
  }
}

const WideTests& fastest_wide_tests() {
  static const WideTests& fastest = fastest_set(all_wide_tests());
  return fastest;
}

}  // namespace pcm::fast
