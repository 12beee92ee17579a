// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "reference/active/active_areas.h"
#include "reference/active/inside_areas.h"
#include "reference/combinatorics/proximity.h"
#include "reference/crossings/crossings.h"
#include "reference/crossings/polygons.h"

namespace pcm::reference {

/// All discrete facts of a contact but its elements: the first half of the pipeline, in its order.
struct Combinatorics {
  std::shared_ptr<const Proximity> near;
  Crossings crossings;
  std::vector<Chain> polygons;
  ActiveFaces E, F;

  const ActiveFaces& of(Side side) const { return side == Side::E ? E : F; }
  InsideAreas inside_areas(const ExactPose& pose) const {
    return find_inside_areas(pose, near->candidates(), crossings, E, F, near->columns(Side::E), near->columns(Side::F));
  }
};

/// `near`: of the same pose, in either problem.
Combinatorics find_combinatorics(const ExactPose& pose, std::shared_ptr<const Proximity> near);
inline Combinatorics find_combinatorics(const ExactPose& pose) {
  return find_combinatorics(pose, std::make_shared<const Proximity>(pose));
}

}  // namespace pcm::reference
