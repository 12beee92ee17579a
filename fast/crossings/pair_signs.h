// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>

#include "fast/predicates/orientation.h"
#include "fast/simd/overlap.h"

/// The signs that tell whether two faces cross, and how.
namespace pcm::fast {

/// Which corners of a face lie above a plane, bit by bit; a corner not above is below.
using Corners = unsigned;

/// The corner that lies on its own side of the other plane, -1 where all three lie on one side.
inline int lone_corner(Corners above) {
  constexpr std::array<std::int8_t, 8> kLone{-1, 0, 1, 2, 2, 1, 0, -1};
  return kLone[above];
}

inline bool is_above(Corners corners, std::size_t corner) {
  return (corners >> corner & 1U) != 0;
}

inline Corners find_corners_above(const std::array<RankedPoint, 3>& plane, const std::array<RankedPoint, 3>& points,
                                  double sure, WorkCounters& work) {
  const OrientedPlane oriented(plane[0], plane[1], plane[2], sure);
  Corners corners = 0;
  for (std::size_t k = 0; k < 3; ++k) corners |= static_cast<Corners>(oriented.above(points[k], work)) << k;
  return corners;
}

inline std::size_t cyclic_corner(int k) {
  return static_cast<std::size_t>(k < 3 ? k : k - 3);
}

/// What is known of a pair of faces that may cross.
struct PairSigns {
  Corners above_of_E = 0, above_of_F = 0;  ///< corners of e above f, and of f above e
  unsigned passing = 0;                    ///< as in SureSigns
};

/// Finds which edges of e and f pass through the other face: none where the faces do not cross. The planes meet in a
/// line; on it lie the two points where edges of e at its lone corner a meet the plane of f, and the two where edges of
/// f at its lone corner p meet the plane of e. The signs s_ij = orientation(a, a_i, p, p_j) order those points along
/// the line, and an edge of e passes through f where its point lies between the two of f: where its two signs differ.
/// Likewise for the edges of f. So two of the four do, or none. At most 10 signs, of which `known` may spare 6.
inline PairSigns find_signs(const std::array<RankedPoint, 3>& e, const std::array<RankedPoint, 3>& f,
                            const SureSigns& known, double sure, WorkCounters& work) {
  PairSigns result;
  result.above_of_E = known.of_E() ? known.above_of_E() : find_corners_above(f, e, sure, work);
  const int lone_E = lone_corner(result.above_of_E);
  if (lone_E < 0) return result;
  result.above_of_F = known.of_F() ? known.above_of_F() : find_corners_above(e, f, sure, work);
  const int lone_F = lone_corner(result.above_of_F);
  if (lone_F < 0) return result;

  const RankedPoint& a = e[cyclic_corner(lone_E)];
  const RankedPoint& p = f[cyclic_corner(lone_F)];
  unsigned s[2][2];
  for (int i = 0; i < 2; ++i) {
    const OrientedPlane through_p(a, e[cyclic_corner(lone_E + 1 + i)], p, sure);
    for (int j = 0; j < 2; ++j) s[i][j] = through_p.above(f[cyclic_corner(lone_F + 1 + j)], work) ? 1 : 0;
  }
  result.passing = (s[0][0] ^ s[0][1]) | (s[1][0] ^ s[1][1]) << 1 | (s[0][0] ^ s[1][0]) << 2 | (s[0][1] ^ s[1][1]) << 3;
  return result;
}

/// Where one crossing of a pair of faces lies, seen from the pair.
struct EdgePassage {
  Side edge_side;
  int corner;  ///< the directed edge of its face that starts at this corner

  bool operator==(const EdgePassage&) const = default;
};

/// How two faces cross: the two crossings that bound their segment.
struct PairCrossing {
  EdgePassage start, end;

  bool operator==(const PairCrossing&) const = default;
};

/// How two faces cross, some of whose edges pass through the other. Circulation: a directed edge of e from above to
/// below f ends the segment, one of f that does so starts it.
inline PairCrossing pair_crossing(const PairSigns& signs) {
  const int lone_E = lone_corner(signs.above_of_E), lone_F = lone_corner(signs.above_of_F);
  const unsigned starting = (is_above(signs.above_of_E, cyclic_corner(lone_E)) ? 0b0010U : 0b0001U) |
                            (is_above(signs.above_of_F, cyclic_corner(lone_F)) ? 0b0100U : 0b1000U);
  assert(std::popcount(signs.passing & starting) == 1 && std::popcount(signs.passing & ~starting) == 1);
  const auto passage = [&](unsigned edge) -> EdgePassage {
    const int number = std::countr_zero(edge);
    const int lone = number < 2 ? lone_E : lone_F;
    return {number < 2 ? Side::E : Side::F, number % 2 == 0 ? lone : static_cast<int>(cyclic_corner(lone + 2))};
  };
  return {passage(signs.passing & starting), passage(signs.passing & ~starting)};
}

}  // namespace pcm::fast
