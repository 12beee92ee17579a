// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/candidates.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace pcm::reference {
namespace {

using IndexedBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Index>;

std::vector<IndexedBox> indexed(const std::vector<Box>& boxes) {
  std::vector<IndexedBox> result;
  result.reserve(boxes.size());
  for (Index i = 0; i < static_cast<Index>(boxes.size()); ++i) {
    double lower[3], upper[3];
    for (int j = 0; j < 3; ++j) {
      lower[j] = boxes[i].lower[j];
      upper[j] = boxes[i].upper[j];
    }
    result.emplace_back(lower, upper, i);
  }
  return result;
}

}  // namespace

std::vector<IndexPair> meeting_boxes(const std::vector<Box>& a, const std::vector<Box>& b) {
  std::vector<IndexedBox> boxes_a = indexed(a), boxes_b = indexed(b);
  std::vector<IndexPair> pairs;
  CGAL::box_intersection_d(
      boxes_a.begin(), boxes_a.end(), boxes_b.begin(), boxes_b.end(),
      [&pairs](const IndexedBox& i, const IndexedBox& j) { pairs.emplace_back(i.info(), j.info()); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

FaceBoxes make_face_boxes(const ExactPose& pose, Side side) {
  FaceBoxes boxes;
  const Index count = static_cast<Index>(pose.surface(side).mesh.faces.size());
  boxes.faces.reserve(count);
  for (Index f = 0; f < count; ++f) {
    boxes.faces.push_back(pose.face_box(side, f));
    if (f == 0) boxes.all = boxes.faces[0];
    boxes.all.include(boxes.faces[f]);
  }
  return boxes;
}

std::vector<IndexPair> candidate_pairs(const FaceBoxes& boxes_E, const FaceBoxes& boxes_F) {
  // Only faces that reach into the other surface's box can take part.
  const auto reaching = [](const FaceBoxes& mine, const Box& others, std::vector<Box>& boxes) {
    std::vector<Index> faces;
    for (Index f = 0; f < static_cast<Index>(mine.faces.size()); ++f)
      if (mine.faces[f].meets(others)) {
        faces.push_back(f);
        boxes.push_back(mine.faces[f]);
      }
    return faces;
  };
  std::vector<Box> near_E, near_F;
  const std::vector<Index> faces_E = reaching(boxes_E, boxes_F.all, near_E);
  const std::vector<Index> faces_F = reaching(boxes_F, boxes_E.all, near_F);
  std::vector<IndexPair> pairs = meeting_boxes(near_E, near_F);
  for (auto& [e, f] : pairs) {
    e = faces_E[e];
    f = faces_F[f];
  }
  return pairs;
}

}  // namespace pcm::reference
