// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "fast/clipped/cut_stretches.h"
#include "fast/clipped/hiding_line.h"
#include "fast/force/element_motion.h"
#include "fast/prism/convex_polygon.h"

namespace pcm::fast {

/// What is visible of a face f of the slave, and how far it counts.
struct SeenPart : SeenFaces {
  std::span<const ConvexPolygon> pieces;
  const Moments& moments;  ///< of these, of min(depth, most)
  double most;             ///< max_penetration, m
};

/// Scratch memory of motion_of_part.
struct PartMotionScratch {
  CutStretches cuts;
  std::vector<CutStretch> open;  ///< stretches with a piece on one side, whose line is still to be found
  SeenBeyond beyond;
};

/// How the element that a part makes changes as the slave moves, seen from the master, by d(x) = dr + a x (x - r).
///
/// The integral M of q over the part P, in (s, t), changes by the integral of dq over P and by that over its border of
/// q times how far that moves outwards. With G_s and G_t the gradients of s and t, n_k = -n, and g_h = N_h / (n_k .
/// N_h): at a fixed place the depth of a face h of the slave grows by g_h . d(X), X being the point of h there. Along a
/// side from one end to the other, (ds, dt) in (s, t), the border moves outwards by, times the side's length,
///
///   an edge of h:               (dt G_s - ds G_t) . d(X), X on the edge
///   h meets the master's plane: -l g_h . d(X), where l = dt / (grad d_h)_s = -ds / (grad d_h)_t, X on that line
///   h passes through f:         (dt G_s - ds G_t) . d(X), X on f
///   a face h of the master passes through f: l g_f . d(X), X on f, l as above with d_h - d_f in place of d_h
///
/// and by nothing where the side is the master's own. A side on an edge of f that is also the master's, to within
/// roundings, is the edge's where f's sheet ends there as the lines see it, and the master's where it goes on:
/// whichever of the two it was cut along, and whether or not a sliver between them was dropped. It is not the edge's
/// where the master's next face has an element with f: what it sees between the two has the edge for its border.
/// Whatever else divides P is a side of two pieces and counts for neither; where on such a line, of an edge beyond its
/// ends, one of the two is hidden by another face that has its border just there, it is that face's (hiding_line.h). So
/// is a side on an edge of f where the slave's face beyond it, with which the sheet goes on, is hidden from there on:
/// all of it, for what the pieces of that face show beside the edge has that line for its own border. min(depth, most)
/// is continuous: where it begins to be clamped nothing is added. All is of degree three at most along a side and of
/// degree two over a piece, so that the integrals are exact but for roundings.
///
/// A slope that is too large for doubles, or whose moments about Mf are, counts as 0.
ElementMotion motion_of_part(const SeenPart& part, PartMotionScratch& scratch);

}  // namespace pcm::fast
