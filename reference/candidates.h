// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "reference/exact_pose.h"

/// Which pairs are worth an exact look. Boxes are closed and hold the features of both problems, so none is missed.
namespace pcm::reference {

using IndexPair = std::pair<Index, Index>;

/// All pairs (i, j) whose boxes a[i], b[j] have a point in common, ascending. O(n log^3 n + pairs).
std::vector<IndexPair> meeting_boxes(const std::vector<Box>& a, const std::vector<Box>& b);

/// The boxes of one surface's faces in Me, and the box around them all.
struct FaceBoxes {
  std::vector<Box> faces;
  Box all;
};
FaceBoxes make_face_boxes(const ExactPose& pose, Side side);

/// Face pairs (e, f) whose boxes meet, ascending.
std::vector<IndexPair> candidate_pairs(const FaceBoxes& boxes_E, const FaceBoxes& boxes_F);

}  // namespace pcm::reference
