// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/proximity.h"

#include <algorithm>

#include "reference/active_areas.h"

namespace pcm::reference {

namespace {

/// Each face's box holds both surfaces.
void put_everywhere(FaceBoxes& boxes_E, FaceBoxes& boxes_F) {
  Box all = boxes_E.all;
  all.include(boxes_F.all);
  for (FaceBoxes* const boxes : {&boxes_E, &boxes_F}) {
    boxes->all = all;
    std::fill(boxes->faces.begin(), boxes->faces.end(), all);
  }
}

}  // namespace

Proximity::Proximity(const ExactPose& pose, CandidateRegion region)
    : boxes_E_(make_face_boxes(pose, Side::E)), boxes_F_(make_face_boxes(pose, Side::F)) {
  if (region == CandidateRegion::everywhere) put_everywhere(boxes_E_, boxes_F_);
  candidates_ = candidate_pairs(boxes_E_, boxes_F_);
  columns_E_ = columns_above_vertices(pose, Side::E, boxes_F_);
  columns_F_ = columns_above_vertices(pose, Side::F, boxes_E_);
}

const BoxTree& Proximity::tree(Side side) {
  std::optional<BoxTree>& tree = side == Side::E ? tree_E_ : tree_F_;
  if (!tree) tree.emplace((side == Side::E ? boxes_E_ : boxes_F_).faces);
  return *tree;
}

}  // namespace pcm::reference
