// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bit>

#include "fast/base/geometry.h"
#include "fast/posed/posed_pair.h"
#include "fast/simd/element_sets.h"

namespace pcm::fast {

using FaceBatch = std::array<Index, kElementLanes>;

/// A lane's face as one object.
inline FaceGeometry geometry_of(const ElementLanes& lanes, std::size_t lane) {
  return {{lanes.p_Me[0][lane], lanes.p_Me[1][lane], lanes.p_Me[2][lane]}, lanes.n_Me[lane], lanes.area.value[lane]};
}

/// Where a lane's face has its corners: of F's, they are transformed on first touch.
inline void enter_corners(PosedPair& posed, Side side, Index face, CornerLanes& corners, std::size_t lane) {
  const Triangle& vertices = posed.surface(side).face(face);
  for (std::size_t k = 0; k < 3; ++k) corners[k][lane] = posed.vertex_Me(side, vertices[k]).data();
}

/// The lane where it is one of these, else some other that is.
inline std::size_t one_of(LaneBits which, std::size_t lane) {
  return has_lane(which, lane) ? lane : static_cast<std::size_t>(std::countr_zero(which));
}

/// Vertices, normals and areas of the first `count` faces of a batch, as FaceGeometry has them.
inline void find_geometry(PosedPair& posed, Side side, const FaceBatch& faces, std::size_t count, ElementLanes& lanes) {
  if (count == 0) return;
  for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
    enter_corners(posed, side, faces[lane < count ? lane : 0], lanes.master_corners, lane);
  }
  const LaneBits known = fastest_wide_elements().geometry(lanes);
  for (std::size_t lane = 0; lane < count; ++lane) {
    if (has_lane(known, lane)) continue;
    // Its squares would overflow or underflow.
    const FaceGeometry geometry({lanes.p_Me[0][lane], lanes.p_Me[1][lane], lanes.p_Me[2][lane]});
    lanes.area.value[lane] = geometry.area;
    lanes.n_Me.set(lane, geometry.n_Me);
  }
}

}  // namespace pcm::fast
