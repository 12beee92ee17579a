// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cfloat>

/// Refuses what fast/floating_point_policy.cmake can't see: flags that a parent project adds behind CMake's variables.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "pcm: -ffast-math, -Ofast and their parts change values and break exact decisions; compile pcm without them"
#endif
// 16 is about half precision only.
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#error "pcm: doubles are computed with excess precision, which breaks exact decisions; compile with SSE (-mfpmath=sse)"
#endif
