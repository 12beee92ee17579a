// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "fast/posed/posed_pair.h"
#include "fast/prism/master_prism.h"
#include "fast/prism/projected_face.h"

namespace pcm::fast {

/// Whether other faces of the master may lie before what one of its faces sees.
enum class OwnFacesBefore : std::uint8_t {
  none,     ///< surely none
  leaning,  ///< only as faces that stand upright on the border of the prism lean over it in the exact problem
  some
};

/// As the thickness computed beforehand says it, for whatever is seen no deeper than this, m: in the rounded problem
/// and in the exact one.
OwnFacesBefore own_faces_before(const PosedPair& posed, Side master, const FaceGeometry& geometry, Index face,
                                double deepest);

/// The corners of another face of the master.
SeenCorners see_own_corners(PosedPair& posed, Side master, Index master_face, const MasterPrism& prism, Index face);

}  // namespace pcm::fast
