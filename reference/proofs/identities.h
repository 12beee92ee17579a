// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/active/inside_areas.h"
#include "reference/oracle.h"

namespace pcm::reference {

/// What must hold of the clipped active areas of two closed surfaces that do not intersect themselves, in rational
/// arithmetic, so with == : together they bound the intersection of the two bodies. Coplanar faces are counted by the
/// convention (opposite ones in neither area, equal ones in E's), with which it holds as well.
struct Identities {
  bool applicable = false;           ///< both surfaces closed
  bool vector_areas_cancel = false;  ///< the two vector areas sum to exactly zero
  bool fluxes_agree = false;         ///< the fluxes of x n_x, y n_y, z n_z over both areas are one and the same number
  double volume = 0;                 ///< that number, correctly rounded
  /// With coplanar faces counted as the tie rule has them, the vector areas sum to exactly zero and the volume is the
  /// same number.
  bool limit_closes = false;
};

/// Exact sums grow with the polygon: milliseconds for tens of crossings, seconds for thousands. For tests and proofs.
Identities prove_identities(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Problem problem, const Pose& pose);

/// The same of areas that were found at a pose of closed surfaces.
Identities identities_of(const InsideAreas& areas, const ExactPose& pose);

}  // namespace pcm::reference
