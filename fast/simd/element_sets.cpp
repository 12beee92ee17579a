// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/simd/element_sets.h"

#include "fast/simd/element_kernels.h"
#include "fast/simd/instruction_set.h"

namespace pcm::fast {

extern const WideElements kWideElementsAvx2;  // where kWithAvx2

std::array<const WideElements*, 2> all_wide_elements() {
  if constexpr (kWithAvx2) {
    return runnable_sets(kElements, kWideElementsAvx2);
  } else {
    return {&kElements, nullptr};
  }
}

const WideElements& fastest_wide_elements() {
  static const WideElements& fastest = fastest_set(all_wide_elements());
  return fastest;
}

}  // namespace pcm::fast
