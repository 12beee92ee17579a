// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/combinatorics/combinatorics.h"

#include <utility>

namespace pcm::reference {

Combinatorics find_combinatorics(const ExactPose& pose, std::shared_ptr<const Proximity> near) {
  const Orientation orientation(pose);
  Combinatorics found;
  found.near = std::move(near);
  found.crossings = find_crossings(orientation, found.near->candidates());
  found.polygons = chain_polygons(found.crossings);
  found.E = find_active_faces(orientation, Side::E, found.crossings, found.near->columns(Side::E));
  found.F = find_active_faces(orientation, Side::F, found.crossings, found.near->columns(Side::F));
  return found;
}

}  // namespace pcm::reference
