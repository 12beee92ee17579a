// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "reference/active_areas.h"
#include "reference/coplanar.h"
#include "reference/crossing_points.h"

/// Clipped active areas (PCM section 5): of each face, the integral of the other surface's winding number over it.
///
/// By Green's theorem, with c the component in which the face's doubled normal N is greatest and o any point of its
/// plane,
///   alpha = 1 / (2 N_c) * sum over chords (p, q) of weight * ((p - o) x (q - o))_c,
/// area = alpha |N|, vector area = alpha N. Chords bound the part inside, counted with multiplicity: the segments of
/// the face's crossing pairs (weight 1), and on each directed edge (a, b) of the face the winding number w(a) over (a,
/// b) and each crossing's change of it over (crossing, b). The order of crossings along an edge does not matter.
///
/// Coplanar faces, other surface closed. A face with a coplanar overlap is looked at from just inside its own body:
/// moved by -s N, s -> 0+, before the tie rule. An overlap with opposite normals then lies outside the other body, one
/// with equal normals inside. So this gives the area without opposite overlaps and with equal ones: E's by the
/// convention; F's is less by the equal ones. All other faces' areas are continuous in the vertices, so the plain tie
/// rule is right for them.
///
/// Coplanar faces, other surface open. It bounds no body, so the convention says nothing; the area is what the tie rule
/// gives. Tilted this way or that, the other surface lies above the face, below it, or ends in it (then the area counts
/// as 0), so any tie rule gives between nothing and the whole face.
namespace pcm::reference {

/// One face with all that Green's theorem needs; crossings count in ClippedAreas::points.
struct FaceClip {
  struct EdgeCrossing {
    int corner;  ///< on the edge from this corner to the next
    int delta;   ///< change of the winding number along it
    Index crossing;
  };
  Index face = 0;
  int axis = -1;  ///< component in which N is greatest; -1 for a zero-area face
  std::array<int, 3> winding{};
  std::vector<EdgeCrossing> on_edges;
  std::vector<std::array<Index, 2>> segments;  ///< the inside on the left seen from outside
  std::vector<Index> overlaps;                 ///< its coplanar overlaps, in ClippedAreas::overlaps
  bool limited = false;  ///< other surface open: winding numbers are relative, area within [0, face]
};

struct ClippedAreas {
  CrossingPoints points;  ///< those of the polygons first, then those of faces moved inward
  std::vector<CoplanarOverlap> overlaps;
  std::vector<FaceClip> E;  ///< faces with a part inside, or a coplanar overlap, ascending
  std::vector<FaceClip> F;
  Index undefined = 0;  ///< faces a border of the other surface ends in
};

/// `columns_*` as find_active_faces had them.
ClippedAreas clip_active_areas(const ExactPose& pose, const std::vector<IndexPair>& candidates,
                               const Crossings& crossings, const ActiveFaces& active_E, const ActiveFaces& active_F,
                               const std::vector<IndexPair>& columns_E, const std::vector<IndexPair>& columns_F);

/// Calls chord(weight, p, q) for every chord that bounds the face's part inside (coplanar overlaps as seen from
/// inside).
template <class T, class Chord>
void for_each_chord(const FaceClip& clip, const std::array<Vec3<T>, 3>& corners, const std::vector<Vec3<T>>& positions,
                    const Chord& chord) {
  for (const auto& [start, end] : clip.segments) chord(1, positions[start], positions[end]);
  for (int i = 0; i < 3; ++i)
    if (clip.winding[i] != 0) chord(clip.winding[i], corners[i], corners[(i + 1) % 3]);
  for (const FaceClip::EdgeCrossing& x : clip.on_edges)
    chord(x.delta, positions[x.crossing], corners[(x.corner + 1) % 3]);
}

}  // namespace pcm::reference
