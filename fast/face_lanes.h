// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "fast/geometry.h"
#include "fast/workspace.h"

namespace pcm::fast {

using FaceBatch = std::array<Index, kElementLanes>;

/// A lane's face as one object.
inline FaceGeometry geometry_of(const ElementLanes& lanes, std::size_t lane) {
  return {{lanes.p_Me[0][lane], lanes.p_Me[1][lane], lanes.p_Me[2][lane]}, lanes.n_Me[lane], lanes.area.value[lane]};
}

/// Vertices, normals and areas of the first `count` faces of a batch, as FaceGeometry has them.
inline void find_geometry(Workspace::Data& workspace, Side side, const FaceBatch& faces, std::size_t count) {
  ElementLanes& lanes = workspace.element_lanes;
  for (std::size_t lane = 0; lane < count; ++lane) {
    const std::array<Eigen::Vector3d, 3> p = workspace.side(side).posed.face_Me(faces[lane], workspace.contact.work);
    for (std::size_t k = 0; k < 3; ++k) lanes.p_Me[k].set(lane, p[k]);
  }
  const LaneBits known = workspace.wide_elements.geometry(lanes);
  for (std::size_t lane = 0; lane < count; ++lane) {
    if (has_lane(known, lane)) continue;
    // Its squares would overflow or underflow.
    const FaceGeometry geometry({lanes.p_Me[0][lane], lanes.p_Me[1][lane], lanes.p_Me[2][lane]});
    lanes.area.value[lane] = geometry.area;
    lanes.n_Me.set(lane, geometry.n_Me);
  }
}

}  // namespace pcm::fast
