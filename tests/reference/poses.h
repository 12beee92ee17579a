// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "fast/inputs.h"
#include "meshes/triangle_mesh.h"

namespace pcm::reference {

inline Pose moved_by(double x, double y, double z) {
  Pose pose;
  pose.r = {x, y, z};
  return pose;
}

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
  const Index offset = static_cast<Index>(outer.vertices.size());
  outer.vertices.insert(outer.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  for (const Triangle& t : inner.faces) outer.faces.push_back({t[0] + offset, t[2] + offset, t[1] + offset});
  return outer;
}

}  // namespace pcm::reference
