// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "fast/barycentric/line_memory.h"
#include "fast/barycentric/penetration_line.h"
#include "fast/base/fast_clear_array.h"
#include "fast/crossings/crossings.h"
#include "fast/simd/elements.h"
#include "fast/simd/face_lanes.h"

namespace pcm::fast {

/// Where walks over the slave start, what their ends are compared with, and scratch memory.
struct PenetrationWalks {
  FastClearArray<Index> slave_nearby;  ///< by face of the master: a face of the slave near its penetration line
  Index last = -1;                     ///< face of the slave near the last penetration line, -1: none
  bool may_walk = false;               ///< roundings are so small that the slave's clearance counts
  DecisionLimits limits;
  LineNodes open;
  LineTrace trace;  ///< of a line that is to be remembered

  /// To be called once a pose and master. Faces that cross one of the slave start there.
  void start(const PosedPair& posed, const Crossings& crossings, Side master);
};

/// What is remembered of the lines of up to four faces; nullptr: nothing.
using RememberedLines = std::array<const LineMemory::Line*, kElementLanes>;

/// The results of find_penetration but for `first_met`, for up to four faces at once, by walks over the slave, each
/// from the face found at the last pose, for a neighbour or, where there is none, for the last face. Where the faces'
/// clearance and thickness, or what is remembered, say that nothing else is met: near O(1). Else by find_penetration.
/// The lanes hold the faces' geometry. `walks` has been started for this pose and master.
/// `memory`: of the lines at the last pose, or nullptr; it is told what is found.
void find_penetrations(PosedPair& posed, Side master, const FaceBatch& faces, std::size_t count, ElementLanes& lanes,
                       PenetrationWalks& walks, LineMemory* memory, const RememberedLines& lines,
                       std::array<Penetration, kElementLanes>& penetrations);

/// The same where all lines are settled, and some have an element: nothing but depths is found.
void find_settled(PosedPair& posed, Side master, const FaceBatch& faces, std::size_t count,
                  const RememberedLines& lines, ElementLanes& lanes,
                  std::array<Penetration, kElementLanes>& penetrations);

}  // namespace pcm::fast
