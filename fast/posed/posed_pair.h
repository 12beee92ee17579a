// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "fast/posed/placement.h"
#include "fast/posed/transform.h"
#include "fast/surface/prepared_surface.h"
#include "pcm/inputs.h"
#include "pcm/work_counters.h"

namespace pcm::fast {

/// Both surfaces of a pairing as the rounded problem has them at one pose (PCM section 1), and how much work was done
/// there so far. Not const for its readers, as vertices of F are computed when they are first asked for, and work is
/// counted; but no value that was read ever changes.
struct PosedPair {
  Placement placement;
  std::array<PosedSurface, 2> surfaces;
  WorkCounters work;

  PosedSurface& operator[](Side side) { return surfaces[static_cast<std::size_t>(side)]; }
  const PreparedSurface& surface(Side side) const { return surfaces[static_cast<std::size_t>(side)].surface(); }
  const Eigen::Vector3d& vertex_Me(Side side, Index v) { return (*this)[side].vertex_Me(v, work); }
  std::array<Eigen::Vector3d, 3> face_Me(Side side, Index face) { return (*this)[side].face_Me(face, work); }

  /// `orthogonality_error`: the pose's. `with_roundings`: whether sharp roundings of F's vertices will be asked for.
  void place(const PreparedSurface& E, const PreparedSurface& F, const Pose& pose, double orthogonality_error,
             bool with_roundings) {
    work = {};
    placement = Placement(E, F, pose, orthogonality_error);
    (*this)[Side::E].place_E(E);
    (*this)[Side::F].place_F(F, pose, E.mesh.vertices.size(), with_roundings);
  }
  /// The same surfaces at the same pose, where no sharp rounding will be asked for.
  void place_like(const PosedPair& other) {
    work = {};
    placement = other.placement;
    const PreparedSurface& E = other.surface(Side::E);
    (*this)[Side::E].place_E(E);
    (*this)[Side::F].place_F(other.surface(Side::F), other.surfaces[1].pose(), E.mesh.vertices.size(), false);
  }
};

}  // namespace pcm::fast
