// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace pcm::fast {

/// How a number changes as a body moves by dr and turns by a about Mf: by_position . dr + by_rotation . a.
struct MotionSlope {
  Eigen::Vector3d by_position = Eigen::Vector3d::Zero();
  Eigen::Vector3d by_rotation = Eigen::Vector3d::Zero();
};

/// How an element of the clipped scheme changes as the slave moves, the master at rest: the area of what is seen, its
/// mean penetration, and where the centre of pressure is, s (p1 - p0) + t (p2 - p0) from p0.
struct ElementMotion {
  MotionSlope area;   ///< of m^2
  MotionSlope depth;  ///< of m
  MotionSlope s, t;
  Eigen::Vector3d edge_s_Me, edge_t_Me;  ///< p1 - p0, p2 - p0, m
};

}  // namespace pcm::fast
