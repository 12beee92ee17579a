// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/moved_poses.h"

#include <algorithm>
#include <cmath>

#include "compare/poses/rounded_vertices.h"

namespace pcm::compare {

std::vector<Pose> moved_poses(const Pose& pose, double scale, std::int64_t most) {
  const double ulp = ulp_of(scale);
  std::vector<Pose> moved;
  if (most == 0 || !std::isfinite(ulp)) return moved;
  for (std::int64_t ulps = 1;; ulps = std::min(2 * ulps, most)) {
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          if (x == 0 && y == 0 && z == 0) continue;
          moved.push_back(pose);
          moved.back().r += static_cast<double>(ulps) * ulp * Eigen::Vector3d(x, y, z);
        }
    if (ulps == most) return moved;
  }
}

}  // namespace pcm::compare
