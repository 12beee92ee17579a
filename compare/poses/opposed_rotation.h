// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "compare/random/random.h"

namespace pcm::compare {

/// A rotation A that lays A `normal_F` opposite to `normal_E`, both of length 1, but for a tilt by an angle of which
/// `half_tilt` is the tangent of the half; turned about that line, and tilted, in directions that are drawn.
Eigen::Matrix3d draw_opposed_rotation(const Eigen::Vector3d& normal_E, const Eigen::Vector3d& normal_F,
                                      double half_tilt, PoseRandom& random);

}  // namespace pcm::compare
