// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// Of the box around the vertices, m; 0 without any.
inline double greatest_extent(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0;
  Eigen::Vector3d low = mesh.vertices.front(), high = low;
  for (const Eigen::Vector3d& x : mesh.vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).maxCoeff();
}

}  // namespace pcm::compare
