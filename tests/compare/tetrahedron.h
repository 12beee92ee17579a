// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <utility>

#include "pcm/triangle_mesh.h"

namespace pcm::compare {

using Corners = std::array<Eigen::Vector3d, 4>;

/// Oriented outward, whichever way its corners run.
inline TriangleMesh tetrahedron(Corners x) {
  if ((x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) < 0) std::swap(x[0], x[1]);
  TriangleMesh mesh;
  mesh.vertices.assign(x.begin(), x.end());
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

}  // namespace pcm::compare
