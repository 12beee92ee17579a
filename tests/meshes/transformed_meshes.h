// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pcm/triangle_mesh.h"

/// A surface in another place or size, for tests.
namespace pcm {

inline TriangleMesh translated(TriangleMesh mesh, const Eigen::Vector3d& by) {
  for (Eigen::Vector3d& x : mesh.vertices) x += by;
  return mesh;
}

inline TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Eigen::Vector3d& x : mesh.vertices) x *= factor;
  return mesh;
}

}  // namespace pcm
