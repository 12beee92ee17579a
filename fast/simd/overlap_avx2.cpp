// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2.
#include "fast/simd/overlap_kernels.h"

namespace pcm::fast {

extern const WideTests kWideTestsAvx2;
const WideTests kWideTestsAvx2 = kTests;

}  // namespace pcm::fast
