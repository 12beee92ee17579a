// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "compare/poses/rounded_vertices.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// Two surfaces in a pose, as the rounded problem has them (PCM section 1). Refers to the meshes.
struct PlacedSurfaces {
  PlacedSurfaces(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const Pose& pose)
      : E(mesh_E), F(mesh_F), vertices_F_Me(rounded_vertices(mesh_F, pose)) {}

  const TriangleMesh& mesh(Side side) const { return side == Side::E ? E : F; }
  const std::vector<Eigen::Vector3d>& vertices_Me(Side side) const {
    return side == Side::E ? E.vertices : vertices_F_Me;
  }
  /// Of the face's corners, m.
  Eigen::Vector3d centroid_Me(Side side, Index face) const {
    const std::vector<Eigen::Vector3d>& x = vertices_Me(side);
    const Triangle& corners = mesh(side).faces[static_cast<std::size_t>(face)];
    const auto corner = [&](std::size_t k) { return x[static_cast<std::size_t>(corners[k])]; };
    return (corner(0) + corner(1) + corner(2)) / 3;
  }

  const TriangleMesh& E;
  const TriangleMesh& F;
  std::vector<Eigen::Vector3d> vertices_F_Me;
};

}  // namespace pcm::compare
