// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// F's vertices in Me as the rounded problem has them (PCM section 1):
/// x_i = fl(fl(fl(fl(a_i1 x) + fl(a_i2 y)) + fl(a_i3 z)) + r_i). Written anew here, so that neither engine nor oracle
/// is asked what it should have done.
std::vector<Eigen::Vector3d> rounded_vertices(const TriangleMesh& mesh_F, const Pose& pose);

/// Backward error of the rounded problem: the greatest distance, over F's vertices and coordinates, between x_i and the
/// real number it stands for, in ulps of the greatest of |a_i1 x|, |a_i2 y|, |a_i3 z|, |r_i| and |x_i|.
/// The distance is the sum of six rounding errors, each known exactly by an error-free transformation; summing them
/// costs a few 1e-16 of itself. Below 4 always: three products lose half an ulp each, two sums of at most 2 and 3 such
/// terms an ulp each at most, the last one likewise two.
double backward_error_ulps(const TriangleMesh& mesh_F, const Pose& pose);

/// From |x| to the next greater double.
double ulp_of(double x);

/// S of DESIGN section 3: greatest |coordinate| of E, of A x_F, of x_F and of r, m.
double coordinate_scale(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const Pose& pose);

}  // namespace pcm::compare
