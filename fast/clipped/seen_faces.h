// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "fast/clipped/visible_parts.h"
#include "fast/posed/posed_pair.h"
#include "fast/prism/master_prism.h"

namespace pcm::fast {

/// What a master face sees of f, and all that it sees.
struct SeenFaces {
  PosedPair& posed;  ///< asked for the faces' vertices
  Side master;
  Index master_face;
  const MasterPrism& prism;
  const std::vector<ProjectedFace>& faces;  ///< the slave's first, ascending
  std::span<const Overlap> overlaps;        ///< of all these faces, as find_overlaps leaves them
  const ProjectedFace& f;
};

/// Of one of the faces: those that may lie before it.
std::span<const Overlap> overlaps_of(const SeenFaces& seen, const ProjectedFace& face);

/// What the master face sees of f, which carries, as convex pieces. `remaining` is scratch.
void find_visible_pieces(const SeenFaces& seen, std::vector<ConvexPolygon>& pieces,
                         std::vector<ConvexPolygon>& remaining, ClippingError& clipping_error);

}  // namespace pcm::fast
