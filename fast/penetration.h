// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/face_lanes.h"
#include "fast/geometry.h"
#include "fast/line_trace.h"
#include "fast/workspace.h"

namespace pcm::fast {

/// What the penetration line of a master face finds (PCM section 6, barycentric scheme; rule R11).
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
/// depth is off by a few ulps of the distance between the faces over |n_e . n_f|. Near O(log n). Fills `trace` where
/// one is given, without any change of the result.
Penetration find_penetration(Workspace::Data& workspace, Side master, Index face, const FaceGeometry& geometry,
                             LineTrace* trace = nullptr);

/// The same results but for `first_met`, for up to four faces at once, by walks over the slave, each from the face
/// found for a neighbour or, where there is none, from `last` (-1: none). Where clearances and thickness known
/// beforehand say that nothing else is met: near O(1). Else by find_penetration. The lanes hold the faces' geometry and
/// receive their depths. `last` becomes the last face that was found.
void find_penetrations(Workspace::Data& workspace, Side master, const FaceBatch& faces, std::size_t count,
                       ElementLanes& lanes, Index& last, std::array<Penetration, kElementLanes>& penetrations);

/// Whether the thickness computed beforehand already says that the face's penetration line meets no other face of the
/// master as near as `distance`, in the rounded problem and in the exact one alike.
bool thicker_than(const Workspace::Data& workspace, Side master, Index face, const FaceGeometry& geometry,
                  double distance);

}  // namespace pcm::fast
