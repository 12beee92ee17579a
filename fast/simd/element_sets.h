// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "fast/simd/elements.h"

namespace pcm::fast {

/// The fastest that this processor runs.
const WideElements& fastest_wide_elements();

/// Each set that this processor runs, for tests: the portable one first.
std::array<const WideElements*, 2> all_wide_elements();

}  // namespace pcm::fast
