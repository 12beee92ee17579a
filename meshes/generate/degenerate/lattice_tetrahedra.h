// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "pcm/triangle_mesh.h"

namespace pcm::degenerate {

/// Two closed tetrahedra with corners in -2, -1, 0, 1, 2 along each axis, so that vertices, edges and planes coincide
/// in many ways. A pure function of the number; pair 2 k + 1 is pair 2 k with its bodies exchanged.
std::array<TriangleMesh, 2> lattice_tetrahedra(std::uint64_t number);

}  // namespace pcm::degenerate
