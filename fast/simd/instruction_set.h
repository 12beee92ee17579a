// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace pcm::fast {

/// Whether files are also compiled for AVX2 in this build.
#if defined(PCM_WITH_AVX2)
inline constexpr bool kWithAvx2 = true;
#else
inline constexpr bool kWithAvx2 = false;
#endif

/// Of the same functions, compiled twice, those that this processor runs: the portable ones first, the others null
/// where it lacks AVX2.
template <class Functions>
std::array<const Functions*, 2> runnable_sets(const Functions& portable, [[maybe_unused]] const Functions& avx2) {
#if defined(PCM_WITH_AVX2)
  if (__builtin_cpu_supports("avx2")) return {&portable, &avx2};
#endif
  return {&portable, nullptr};
}

template <class Functions>
const Functions& fastest_set(const std::array<const Functions*, 2>& runnable) {
  const auto [portable, wide] = runnable;
  return wide != nullptr ? *wide : *portable;
}

}  // namespace pcm::fast
