// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace pcm::simulate {

/// A camera in perspective. Frame C: origin at the eye, x to the right, y upwards, z towards the viewer, so that what
/// is seen has a negative z. W is the world's frame, z upwards.
struct Camera {
  Eigen::Matrix3d A_CW = Eigen::Matrix3d::Identity();  ///< x_C = A (x_W - eye)
  Eigen::Vector3d eye_W = Eigen::Vector3d::Zero();     ///< m
  double tan_half_height = 1;                          ///< tangent of half the angle of view upwards
  double distance = 1;                                 ///< of the eye from what it looks at, m
  Eigen::Vector3d to_camera(const Eigen::Vector3d& x_W) const { return A_CW * (x_W - eye_W); }
};

/// The page's own view as it opens (page/scene.js, `look`): as near as the box fits with some room, in the middle, seen
/// from in front, a little from the right and above. `aspect` is the picture's width over its height. A box that is a
/// single point is looked at from 1 m away.
Camera camera_on(const Eigen::AlignedBox3d& box_W, double aspect);

}  // namespace pcm::simulate
