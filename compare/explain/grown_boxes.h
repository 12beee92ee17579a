// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/pose/exact_pose.h"

namespace pcm::compare {

/// The box with all that is at most `width` from it along an axis, m, but for rounding.
inline reference::Box grown(reference::Box box, double width) {
  box.lower.array() -= width;
  box.upper.array() += width;
  return box;
}

/// The boxes of a surface's faces, grown, in a tree.
inline reference::BoxTree grown_tree(const reference::ExactPose& pose, Side side, double width) {
  std::vector<reference::Box> boxes = pose.face_boxes(side);
  for (reference::Box& box : boxes) box = grown(box, width);
  return {pose.surface(side).tree, boxes};
}

}  // namespace pcm::compare
