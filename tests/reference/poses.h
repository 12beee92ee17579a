// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <random>
#include <utility>

#include "meshes/generate/degenerate/bodies.h"
#include "tests/shifted_pose.h"

namespace pcm::reference {

/// A rotation from small integers (a quaternion), rounded once an entry, so a rotation to a few ulps.
inline Pose random_pose(std::mt19937_64& random, double spread) {
  const auto draw = [&random] { return static_cast<double>(static_cast<int>(random() % 2001) - 1000) / 1000; };
  double w = draw(), x = draw(), y = draw(), z = draw();
  while (w * w + x * x + y * y + z * z < 0.01) w = draw();
  const double s = 2 / (w * w + x * x + y * y + z * z);
  Pose pose;
  pose.A << 1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),  //
      s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x),        //
      s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y);
  pose.r = {spread * draw(), spread * draw(), spread * draw()};
  return pose;
}

/// `inner` turned inside out and added to `outer`: a body with a cavity.
inline TriangleMesh with_cavity(TriangleMesh outer, const TriangleMesh& inner) {
  return degenerate::joined(std::move(outer), degenerate::inverted(inner));
}

}  // namespace pcm::reference
