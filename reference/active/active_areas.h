// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/crossings/candidates.h"
#include "reference/crossings/crossings.h"
#include "reference/crossings/polygons.h"

namespace pcm::reference {

/// What the contact makes of one surface, lying in the other (PCM section 5).
struct ActiveFaces {
  std::vector<Index> intersected;  ///< faces in a crossing pair, ascending
  std::vector<Index> inner;        ///< uncrossed faces inside the other body, ascending; nested ones included
  std::vector<Index> pockets;      ///< uncrossed faces of negative winding number: the other surface folded over
  std::vector<int> winding;        ///< of the other surface about each vertex; empty where the other is open
  std::vector<bool> inside;        ///< of each vertex: winding >= 1; where the other is open, labelled inside
  std::vector<bool> outside;       ///< of each vertex: not inside; where the other is open, labelled outside
  bool nested = false;             ///< a component lies in the other body without any crossing
  bool ambiguous = false;          ///< a set of uncrossed faces is labelled both ways

  std::vector<Index> active() const;  ///< intersected and inner faces, ascending
};

/// Pairs (vertex of one surface, face of the other) where the vertex may lie below the face: ascending.
std::vector<IndexPair> columns_above_vertices(const ExactPose& pose, Side side, const BoxTree& others);

/// Winding number of the other surface, closed, about vertex v: up a ray in direction +z from v, +1 for each face left
/// through its inside (outward normal up), -1 for each entered. Everything perturbed by the tie rule: the projections
/// move by the x and y of the same perturbation.
int winding_number(const Orientation& orientation, Vertex v, const std::vector<IndexPair>& columns);

/// `side`'s faces and vertices against the other surface. Other surface closed: every vertex by its winding number.
/// Open (no inside without a rule): an edge along which crossings sum up to s > 0 goes in, s < 0 comes out; its ends
/// label the uncrossed faces at them, and all uncrossed faces that shared edges join to these.
ActiveFaces find_active_faces(const Orientation& orientation, Side side, const Crossings& crossings,
                              const std::vector<IndexPair>& columns);

/// Which patch each polygon bounds: polygons are joined along uncrossed edges inside, along edges from a polygon to a
/// vertex inside, and along edges that pass through the other body between two polygons. Numbered by first polygon.
std::vector<Index> group_into_patches(const ExactPose& pose, const Crossings& crossings,
                                      const std::vector<Chain>& polygons, const ActiveFaces& E, const ActiveFaces& F);

}  // namespace pcm::reference
