// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
// Compiled for processors with AVX2.
#include "fast/simd/element_kernels.h"

namespace pcm::fast {

extern const WideElements kWideElementsAvx2;
const WideElements kWideElementsAvx2 = kElements;

}  // namespace pcm::fast
