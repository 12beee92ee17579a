// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/simd/overlap_sets.h"

#include "fast/simd/overlap_kernels.h"

namespace pcm::fast {

#if defined(PCM_WITH_AVX2)
extern const WideTests kWideTestsAvx2;
#endif

std::array<const WideTests*, 2> all_wide_tests() {
  std::array<const WideTests*, 2> sets{&kTests, nullptr};
#if defined(PCM_WITH_AVX2)
  if (__builtin_cpu_supports("avx2")) sets[1] = &kWideTestsAvx2;
#endif
  return sets;
}

const WideTests& fastest_wide_tests() {
  static const WideTests& fastest = []() -> const WideTests& {
    const auto [portable, wide] = all_wide_tests();
    return wide != nullptr ? *wide : *portable;
  }();
  return fastest;
}

}  // namespace pcm::fast
