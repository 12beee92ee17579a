// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/active_areas.h"
#include "reference/candidates.h"
#include "reference/clipped_areas.h"
#include "reference/crossings.h"
#include "reference/polygons.h"

namespace pcm::reference {

/// All discrete facts of a contact but its elements: the first half of the pipeline, in its order.
struct Combinatorics {
  FaceBoxes boxes_E, boxes_F;
  std::vector<IndexPair> candidates;
  Crossings crossings;
  std::vector<Chain> polygons;
  std::vector<IndexPair> columns_E, columns_F;
  ActiveFaces E, F;

  ClippedAreas clip(const ExactPose& pose) const {
    return clip_active_areas(pose, candidates, crossings, E, F, columns_E, columns_F);
  }
};

Combinatorics find_combinatorics(const ExactPose& pose);

}  // namespace pcm::reference
