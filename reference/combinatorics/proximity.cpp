// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/combinatorics/proximity.h"

#include <algorithm>

#include "reference/active/active_areas.h"

namespace pcm::reference {

Proximity::Proximity(const ExactPose& pose, CandidateRegion region) : tree_E_(&pose.surface(Side::E).tree) {
  std::vector<Box> boxes_F = pose.face_boxes(Side::F);
  if (region == CandidateRegion::everywhere) {
    Box all = tree_E_->nodes().front().box;
    for (const Box& box : boxes_F) all.include(box);
    std::fill(boxes_F.begin(), boxes_F.end(), all);
    everywhere_E_ = BoxTree(*tree_E_, std::vector<Box>(pose.surface(Side::E).mesh.faces.size(), all));
    tree_E_ = &everywhere_E_;
  }
  tree_F_ = BoxTree(pose.surface(Side::F).tree, boxes_F);
  candidates_ = meeting_boxes(*tree_E_, tree_F_);
  columns_E_ = columns_above_vertices(pose, Side::E, tree_F_);
  columns_F_ = columns_above_vertices(pose, Side::F, *tree_E_);
}

}  // namespace pcm::reference
