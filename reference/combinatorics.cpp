// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/combinatorics.h"

namespace pcm::reference {

Combinatorics find_combinatorics(const ExactPose& pose) {
  const Orientation orientation(pose);
  Combinatorics found;
  found.boxes_E = make_face_boxes(pose, Side::E);
  found.boxes_F = make_face_boxes(pose, Side::F);
  found.candidates = candidate_pairs(found.boxes_E, found.boxes_F);
  found.crossings = find_crossings(orientation, found.candidates);
  found.polygons = chain_polygons(found.crossings);
  found.columns_E = columns_above_vertices(pose, Side::E, found.boxes_F);
  found.columns_F = columns_above_vertices(pose, Side::F, found.boxes_E);
  found.E = find_active_faces(orientation, Side::E, found.crossings, found.columns_E);
  found.F = find_active_faces(orientation, Side::F, found.crossings, found.columns_F);
  return found;
}

}  // namespace pcm::reference
