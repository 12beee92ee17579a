// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "pcm/triangle_mesh.h"

namespace pcm::generate {

/// Of the solid that a closed, outward surface encloses, in the mesh's own frame.
struct SolidMoments {
  double volume = 0;                                           ///< m^3
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();          ///< m
  Eigen::Matrix3d unit_inertia = Eigen::Matrix3d::Identity();  ///< about the centroid, for unit mass, m^2
};

/// Sums over the tetrahedra between the origin and the faces; exact but for rounding. The same bits on every machine.
SolidMoments solid_moments(const TriangleMesh& mesh);

}  // namespace pcm::generate
