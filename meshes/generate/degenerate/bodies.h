// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "pcm/triangle_mesh.h"

/// Bodies of the catalogue with small integers as coordinates.
namespace pcm::degenerate {

/// Closed tetrahedron with these corners in any order, oriented outward.
TriangleMesh tetrahedron(const std::array<Eigen::Vector3d, 4>& corners);

/// Tetrahedron standing on its tip, the origin; its base is in z = 1, within one metre of the z axis in x and y.
TriangleMesh spike();

/// Tetrahedron with its lower edge on the x axis from -1 to 1 and its upper edge above the y axis in z = 1.
TriangleMesh keel();

/// Tetrahedron with its upper edge on the y axis from -1 to 1 and its lower edge below the x axis in z = -1.
TriangleMesh ridge();

/// Both surfaces as components of one.
TriangleMesh joined(TriangleMesh first, const TriangleMesh& second);

/// The same surface inside out.
TriangleMesh inverted(TriangleMesh mesh);

}  // namespace pcm::degenerate
