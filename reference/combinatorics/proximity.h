// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/crossings/candidates.h"
#include "reference/pose/box_tree.h"
#include "reference/pose/candidate_region.h"
#include "reference/pose/exact_pose.h"

namespace pcm::reference {

/// What is near what in a pose, by boxes that hold all features as both problems have them: one for both.
class Proximity {
 public:
  /// The surfaces of the pose must outlive this.
  explicit Proximity(const ExactPose& pose, CandidateRegion region = CandidateRegion::near);
  Proximity(const Proximity&) = delete;
  Proximity& operator=(const Proximity&) = delete;

  /// Face pairs (e, f) whose boxes meet, ascending.
  const std::vector<IndexPair>& candidates() const { return candidates_; }
  /// Pairs (vertex of `side`, face of the other surface) whose face may lie above the vertex, ascending.
  const std::vector<IndexPair>& columns(Side side) const { return side == Side::E ? columns_E_ : columns_F_; }
  /// The boxes of a surface's faces in Me.
  const BoxTree& tree(Side side) const { return side == Side::E ? *tree_E_ : tree_F_; }

 private:
  const BoxTree* tree_E_;  ///< the surface's own where the faces' boxes are meant: E does not move
  BoxTree everywhere_E_, tree_F_;
  std::vector<IndexPair> candidates_;
  std::vector<IndexPair> columns_E_, columns_F_;
};

}  // namespace pcm::reference
