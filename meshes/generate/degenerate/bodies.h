// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

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

/// The surface of a union of unit cubes, each given by its corner of least coordinates. Cubes must not meet in an edge
/// or a vertex alone: the surface would not be a manifold there.
TriangleMesh union_of_cubes(const std::vector<std::array<int, 3>>& corners);

/// Both surfaces as components of one.
TriangleMesh joined(TriangleMesh first, const TriangleMesh& second);

/// The same surface inside out.
TriangleMesh inverted(TriangleMesh mesh);

}  // namespace pcm::degenerate
