// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pcm/inputs.h"

namespace pcm {

/// F's frame parallel to E's, its origin at (x, y, z) there.
inline Pose shifted(double x, double y, double z) {
  return {Eigen::Matrix3d::Identity(), {x, y, z}};
}

}  // namespace pcm
