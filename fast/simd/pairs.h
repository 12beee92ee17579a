// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "fast/simd/elements.h"

namespace pcm::fast {

/// Roundings of a product of two or three differences of points, and of the volumes below, in units of the product of
/// their 1-norms: 32 u. Of a product alone 16 u would do.
inline constexpr double kVolumeRoundings = 0x1p-48;
/// Volumes that are no greater tell nothing.
inline constexpr double kLeastSureVolume = 0x1p-300;

/// Four pairs of faces, e of E and f of F.
struct PairLanes {
  CornerLanes e{}, f{};
};

/// Which of their edges pass through the other face, where that is sure, and for how long.
struct PairsLookedAt {
  LaneBits sure = 0;
  std::array<std::uint32_t, kElementLanes> signs{};  ///< of SureSigns, with those of corners where some edge passes
  DoubleLanes margin;  ///< as in fast/crossings/pair_margin.h, 0 where it can't be told, m
};

/// Looks at them in double precision. All is told from ten signed volumes: with a and p corners of e and f, b_i and c_j
/// the sides of both from there, i, j = 1, 2, and x = p - a, from the heights N_E . (f_k - e_0) and N_F . (e_k - f_0),
/// N_E and N_F being normals, and from s_ij = (b_i x c_j) . x, a and p being the corners that lie alone on their side
/// of the other plane. An edge passes where two of these signs differ (find_signs, fast/crossings/pair_signs.h). The
/// line along b_i and that along a side of f at p are |s_ij| / |b_i x c_j| apart; with f's third side c_2 - c_1 the
/// volume is
///     (b_i x (c_2 - c_1)) . (x + c_1) = s_i2 - s_i1 - N_F . b_i,
/// likewise (c_j x (b_2 - b_1)) . (x - b_1), but for its sign, s_2j - s_1j - N_E . c_j. Seen along b_i x c_j, corners
/// of e lie at 0, 0 and N_E . c_j (i = 2; less than 0 by as much for i = 1), those of f at s_ij, s_ij and N_F . b_i
/// farther (j = 1; nearer for j = 2): the gap between the two parts them.
///
/// Error, u = 2^-53, all in 1-norms: with beta the sum of e's sides from e_0, zeta that of f's, and gamma no less than
/// any f_k - e_i, a height over f is off by 8 u zeta^2 gamma, over e by 8 u beta^2 gamma, s_ij by 8 u beta zeta gamma:
/// three differences, two roundings of the normal, three of the sum. The other volumes are sums of up to two of each
/// kind, and four roundings of what is no more than these; so 32 u of each that takes part covers all. Normals, and
/// differences of two b_i x c_j, are off by less than 32 u zeta^2, 32 u beta^2 or 32 u beta zeta. No lane is sure whose
/// volumes or margins are so small that products of them underflow. No coordinate may be as great as 2^80 m, which the
/// caller sees to: products of ten lengths then are less than 2^840.
using LookAtPairs = PairsLookedAt (*)(const PairLanes& lanes);

}  // namespace pcm::fast
