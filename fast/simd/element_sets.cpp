// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/simd/element_sets.h"

#include "fast/simd/element_kernels.h"

namespace pcm::fast {

#if defined(PCM_WITH_AVX2)
extern const WideElements kWideElementsAvx2;
#endif

std::array<const WideElements*, 2> all_wide_elements() {
  std::array<const WideElements*, 2> sets{&kElements, nullptr};
#if defined(PCM_WITH_AVX2)
  if (__builtin_cpu_supports("avx2")) sets[1] = &kWideElementsAvx2;
#endif
  return sets;
}

const WideElements& fastest_wide_elements() {
  static const WideElements& fastest = []() -> const WideElements& {
    const auto [portable, wide] = all_wide_elements();
    return wide != nullptr ? *wide : *portable;
  }();
  return fastest;
}

}  // namespace pcm::fast
