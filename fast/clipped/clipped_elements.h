// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/active/intersection.h"
#include "fast/clipped/clipped_face.h"
#include "fast/force/element_sum.h"

namespace pcm::fast {

/// Scratch memory of sum_clipped_elements.
struct ClippedScratch {
  ClippedFaceScratch face;
  ElementLanes lanes;
};

/// Forms the contact elements of a master in the clipped scheme (PCM section 6): for each active face e and each slave
/// face f one element, the part of e whose penetration lines leave the slave through f first, before they meet
/// another face of the master. Its area A_k, mean penetration u_k and centre of pressure are integrals over that part,
/// which need be neither convex nor connected, of the linear penetration u, or of min(u, max_penetration) where the law
/// clamps it. Recorded and summed as in the barycentric scheme; elements by master face, then slave face.
///
/// Degenerate cases: a face of the slave with the same normal that lies in e's plane is met at distance 0, so u = 0
/// there (flush faces: the force jumps when the pose passes through); one of opposite normal in e's plane carries
/// nothing and hides what is behind it. Slivers of rounding size may appear or not, their share is as small. Parts
/// whose area or penetration underflows to 0 make no element. Error against the rounded problem: that of lines and
/// depths moved by a few ulps of the greatest coordinate S (fast/clipped/visible_parts.h), so relative to the sum of
/// |F_k| a few ulps times S over the mean penetration, or over the width of what is seen where that is less; flush and
/// nearly flush faces included. Cost: near O(log n + overlapping faces) a master face; parts are cut only where sheets
/// overlap.
///
/// From surfaces to forces: clip_face (clipped_face.h) lets an active face look along its penetration lines
/// (face_view.h: the faces that its prism meets), parts what it sees (visible_parts.h) and integrates the depth over
/// each part (Moments, fast/prism/convex_polygon.h); ElementQueue
/// (fast/force/element_sum.h) applies the law to four at a time and adds up.
MasterForce sum_clipped_elements(const Intersection& intersection, Side master, const ForceProblem& problem,
                                 ClippedScratch& scratch, ElementRecord& record);

}  // namespace pcm::fast
