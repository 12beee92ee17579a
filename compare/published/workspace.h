// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "compare/published/active_faces.h"
#include "compare/published/slave_search.h"
#include "fast/force/element_sum.h"
#include "pcm/contact.h"

namespace pcm::compare::published {

/// A master face whose penetration line came near a face of the slave.
struct MasterLine {
  Index face = 0;
  fast::FaceGeometry geometry;
  PenetrationLine line;
  FirstMet first;
};

/// Scratch memory of both published algorithms and their last answer; one per thread. It grows to what the poses need.
struct Workspace {
  PosedFaces faces_E, faces_F;
  std::vector<std::pair<Index, Index>> open_boxes;
  fast::Contact contact;
  fast::ElementRecord record;

  // The algorithm of 2003.
  std::vector<Segment> segments;
  std::vector<SegmentChain> chains;
  std::vector<Index> patch_of;
  ActiveFaces active_E, active_F;
  std::vector<PosedFace> slaves;  ///< the slave's active faces side by side

  // The variant of 2023.
  fast::FastClearArray<Index> line_of_face;  ///< by master face, of those that came near a slave face
  std::vector<MasterLine> lines;

  PosedFaces& faces(Side side) { return side == Side::E ? faces_E : faces_F; }
  ActiveFaces& active(Side side) { return side == Side::E ? active_E : active_F; }
};

}  // namespace pcm::compare::published
