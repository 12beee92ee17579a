// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "fast/simd/overlap.h"

namespace pcm::fast {

/// The fastest that this processor runs.
const WideTests& fastest_wide_tests();

/// Each set that this processor runs, for tests: the portable one first.
std::array<const WideTests*, 2> all_wide_tests();

}  // namespace pcm::fast
