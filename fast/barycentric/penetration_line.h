// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/barycentric/line_memory.h"
#include "fast/base/geometry.h"
#include "fast/posed/posed_pair.h"
#include "fast/prism/line_trace.h"
#include "fast/search/line_search.h"
#include "fast/simd/face_lanes.h"

namespace pcm::fast {

/// What the penetration line of a master face finds (PCM section 6, barycentric scheme).
struct Penetration {
  enum class Outcome : std::uint8_t {
    none,      ///< it meets no face of the slave, or enters it first, or leaves it at distance 0
    too_deep,  ///< it would leave the slave, but meets another face of the master before
    element,   ///< it leaves the slave through `slave_face` at distance `depth`
  };
  Outcome outcome = Outcome::none;
  Index slave_face = -1;
  double depth = 0;      ///< u (11), m; not negative
  Index first_met = -1;  ///< the first face of the slave that the line meets, whatever comes of it; -1 where none
};

/// Follows the penetration line of face `face` of side `master`. Every decision is exact on the rounded problem; the
/// depth is off by a few ulps of the distance between the faces over |n_e . n_f|. Near O(log n). `open` is scratch.
/// Fills `trace` where one is given, without any change of the result.
Penetration find_penetration(PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, LineNodes& open,
                             LineTrace* trace = nullptr);

/// Where walks over the slave start, and scratch memory.
struct PenetrationWalks {
  FastClearArray<Index> slave_nearby;  ///< by face of the master: a face of the slave near its penetration line
  Index last = -1;                     ///< face of the slave near the last penetration line, -1: none
  LineNodes open;
  LineTrace trace;  ///< of a line that is to be remembered
};

/// The same results but for `first_met`, for up to four faces at once, by walks over the slave, each from the face
/// found for a neighbour or, where there is none, for the last. Where clearances and thickness known beforehand say
/// that nothing else is met: near O(1). Else by find_penetration. The lanes hold the faces' geometry and receive their
/// depths. `memory`: of the lines at the last pose, or nullptr.
void find_penetrations(PosedPair& posed, Side master, const FaceBatch& faces, std::size_t count, ElementLanes& lanes,
                       PenetrationWalks& walks, LineMemory* memory,
                       std::array<Penetration, kElementLanes>& penetrations);

/// Whether the thickness computed beforehand already says that the face's penetration line meets no other face of the
/// master as near as `distance`, in the rounded problem and in the exact one alike.
bool thicker_than(const PosedPair& posed, Side master, Index face, const FaceGeometry& geometry, double distance);

}  // namespace pcm::fast
