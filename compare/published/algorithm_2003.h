// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/published/workspace.h"
#include "fast/force/element_sum.h"

namespace pcm::compare::published {

/// The algorithm as published in 2003, to measure the engine against: written from the paper's description alone, in
/// floating point, with the engine's force law (14) to (24). Binary trees of boxes; a test of triangles that gives
/// their intersection lines (3.1); polygons by snapping end points, active areas by flooding, one contact element at
/// the barycentre of each active master face, its slave face searched over the slave's whole active area (3.2).
///
/// Where the paper is silent it does the sensible thing: an edge crossed more than once has each end told by the next
/// crossing; of several slave faces on a penetration line the first decides, as in PCM section 6. What the paper does
/// not have it has not: no tie rule, no clipped areas, nothing nested, ambiguous or too deep.
class Algorithm2003 {
 public:
  /// Throws BadInput where a parameter of the law is out of its range. The meshes must be fit for contact.
  Algorithm2003(TriangleMesh mesh_E, TriangleMesh mesh_F, const ContactLaw& law, Mode mode);

  /// The answer lives in `workspace` until its next use. Throws BadInput where the question or the force is not finite.
  const fast::Contact& evaluate(const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                                Workspace& workspace) const;

 private:
  void find_segments(const Pose& pose, Workspace& workspace) const;
  fast::MasterForce sum_elements(Side master, const fast::ForceProblem& problem, Workspace& workspace) const;

  Surface E_, F_;
  ContactLaw law_;
  Mode mode_;
};

}  // namespace pcm::compare::published
