// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/proximity.h"

#include "reference/active_areas.h"

namespace pcm::reference {

Proximity::Proximity(const ExactPose& pose)
    : boxes_E_(make_face_boxes(pose, Side::E)),
      boxes_F_(make_face_boxes(pose, Side::F)),
      candidates_(candidate_pairs(boxes_E_, boxes_F_)),
      columns_E_(columns_above_vertices(pose, Side::E, boxes_F_)),
      columns_F_(columns_above_vertices(pose, Side::F, boxes_E_)) {}

const BoxTree& Proximity::tree(Side side) {
  std::optional<BoxTree>& tree = side == Side::E ? tree_E_ : tree_F_;
  if (!tree) tree.emplace((side == Side::E ? boxes_E_ : boxes_F_).faces);
  return *tree;
}

}  // namespace pcm::reference
