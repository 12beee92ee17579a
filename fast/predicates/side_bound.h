// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcm::fast {

/// When the sign of a side test D, as LineCoordinates and the kernel `leave` compute it, is sure: where |D| exceeds
///     kSideError M |a| |b| W + kSideUnderflow,
/// which must be below kGreatestSideBound, while M |a| and M |b| exceed kLeastSideProduct. M, a, b, W and where this
/// comes from: fast/search/line_walk.h.
inline constexpr double kSideError = 128 * 0x1p-53;
inline constexpr double kSideUnderflow = 0x1p-900;
inline constexpr double kGreatestSideBound = 0x1p970;
inline constexpr double kLeastSideProduct = 0x1p-500;

}  // namespace pcm::fast
