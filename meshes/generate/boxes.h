// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "pcm/triangle_mesh.h"

/// Flat-faced generators. All lengths in metres; normals point outward; vertices are shared. Every generator throws
/// BadInput naming the parameter that is out of range, and gives the same bits on every machine.
namespace pcm::generate {

/// Closed box between two corners, 8 vertices and 12 faces. Its vertices have the corners' coordinates exactly.
TriangleMesh box(const Eigen::Vector3d& min_corner, const Eigen::Vector3d& max_corner);

/// Closed box of the given extents about the origin.
TriangleMesh box(const Eigen::Vector3d& extents);

/// Closed box whose sides are grids of `subdivisions` cells along x, y and z; each cell is two triangles:
/// 4 (nx ny + ny nz + nz nx) faces. Grid coordinates are min + (max - min) i / n, the corners exact.
TriangleMesh gridded_box(const Eigen::Vector3d& min_corner, const Eigen::Vector3d& max_corner,
                         const std::array<Index, 3>& subdivisions);

/// The same about the origin.
TriangleMesh gridded_box(const Eigen::Vector3d& extents, const std::array<Index, 3>& subdivisions);

/// Closed cube about the origin, `subdivisions` cells along each edge: 12 n^2 faces.
TriangleMesh gridded_box(double edge_length, Index subdivisions);

/// Closed thin box with its gridded top in the plane z = 0, centred in x and y: 4 (nx ny + nx + ny) faces.
TriangleMesh plate(double extent_x, double extent_y, double thickness, Index subdivisions_x = 1,
                   Index subdivisions_y = 1);

/// Open gridded rectangle in the plane z = 0, normal along +z, centred at the origin: 2 nx ny faces.
TriangleMesh rectangle(double extent_x, double extent_y, Index subdivisions_x = 1, Index subdivisions_y = 1);

/// Closed right prism, the wedge of two perpendicular faces: they meet in the lower edge, which lies on the y axis, one
/// rising at `tilt_degrees` from the plane z = 0 towards -x (its inward horizontal is +x), the other towards +x; the
/// top is flat at z = height. 0 < tilt < 90. Along each edge `subdivisions` cells: 2 n^2 + 6 n^2 faces.
TriangleMesh wedge(double tilt_degrees, double height, double width, Index subdivisions = 1);

}  // namespace pcm::generate
