// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pcm::compare {

/// Limits of a law's depths, m, and velocities, m/s, that are neither 0 nor infinite, in what is drawn and what is
/// read: the verdict's bounds hold between them. They are compared with those of elements and divide them. Bodies of
/// 2^-240 m have such depths, but not those that meet by a denormal one; a factor divided by a threshold stays from
/// 2^-600 to 2^600 (kLeastFactor).
inline constexpr double kLeastThreshold = 0x1p-400, kGreatestThreshold = 0x1p400;

}  // namespace pcm::compare
