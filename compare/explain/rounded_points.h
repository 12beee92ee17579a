// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "reference/pose/exact_pose.h"

namespace pcm::compare {

/// In Me, m; of the rounded problem, whose points are doubles.
inline Eigen::Vector3d rounded_point(const reference::ExactPose& pose, reference::Vertex v) {
  return pose.enclosure(v).lower;
}

inline std::array<Eigen::Vector3d, 3> rounded_corners(const reference::ExactPose& pose, Side side, Index face) {
  std::array<Eigen::Vector3d, 3> points;
  for (std::size_t k = 0; k < 3; ++k) points[k] = rounded_point(pose, {side, pose.face(side, face)[k]});
  return points;
}

}  // namespace pcm::compare
