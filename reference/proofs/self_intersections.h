// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "pcm/triangle_mesh.h"

namespace pcm::reference {

/// Pairs of faces, the smaller index first, ascending, that have more in common than the vertex or edge they share as
/// neighbours: they cross, touch, overlap in one plane, or are the same face twice. Exact on the mesh's doubles.
/// Indices must be in range and no face may repeat a vertex. O(n log n) and the pairs whose boxes meet.
std::vector<std::pair<Index, Index>> self_intersections(const TriangleMesh& mesh);

}  // namespace pcm::reference
