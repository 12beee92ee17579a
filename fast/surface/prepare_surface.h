// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fast/surface/prepared_surface.h"

namespace pcm::fast {

/// Prepares a mesh for contact. Throws BadInput, naming what is wrong where and what mends it, when the mesh is unfit
/// (PCM section 2), out of range or has more faces than can be counted. O(n log n) in the number of faces.
PreparedSurface prepare_surface(TriangleMesh mesh);

/// Computes what else is computed for each face when a contact first asks for it. O(n log n).
void look_around_all_faces(const PreparedSurface& surface);

/// Greatest |coordinate| of the faces' vertices along each axis, m.
Eigen::Vector3d max_coordinates_of(const TriangleMesh& mesh);

/// Why the engine takes no surface whose greatest |coordinate| is `max_coordinate`, m; empty where it does.
std::string out_of_range(double max_coordinate);

}  // namespace pcm::fast
