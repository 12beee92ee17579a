// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/peers/triangle_overlap.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace pcm::compare {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;
using Heights = std::array<double, 3>;

Eigen::Vector3d normal_of(const Corners& c) {
  return (c[1] - c[0]).cross(c[2] - c[0]);
}

Heights heights_above(const Corners& plane, const Eigen::Vector3d& normal, const Corners& points) {
  return {normal.dot(points[0] - plane[0]), normal.dot(points[1] - plane[0]), normal.dot(points[2] - plane[0])};
}

bool on_one_side(const Heights& h) {
  return (h[0] > 0 && h[1] > 0 && h[2] > 0) || (h[0] < 0 && h[1] < 0 && h[2] < 0) ||
         (h[0] == 0 && h[1] == 0 && h[2] == 0);
}

struct Interval {
  double low, high;
};

/// Where the triangle meets the other one's plane, along the line both planes share.
Interval interval_along(const Eigen::Vector3d& line, const Corners& c, const Heights& h) {
  // The corner alone on its side of the plane; with a corner in the plane, one whose two edges reach the plane.
  std::size_t alone = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = h[(k + 1) % 3], b = h[(k + 2) % 3];
    if (h[k] != 0 && h[k] * a <= 0 && h[k] * b <= 0) alone = k;
  }
  const double p = line.dot(c[alone]);
  const auto meets = [&](std::size_t other) {
    const double q = line.dot(c[other]);
    return p + (q - p) * (h[alone] / (h[alone] - h[other]));
  };
  const double x = meets((alone + 1) % 3), y = meets((alone + 2) % 3);
  return {std::min(x, y), std::max(x, y)};
}

}  // namespace

bool triangles_overlap(const Corners& first, const Corners& second) {
  const Eigen::Vector3d n_second = normal_of(second);
  const Heights h_first = heights_above(second, n_second, first);
  if (on_one_side(h_first)) return false;
  const Eigen::Vector3d n_first = normal_of(first);
  const Heights h_second = heights_above(first, n_first, second);
  if (on_one_side(h_second)) return false;
  const Eigen::Vector3d line = n_first.cross(n_second);
  const Interval a = interval_along(line, first, h_first), b = interval_along(line, second, h_second);
  return a.low <= b.high && b.low <= a.high;
}

}  // namespace pcm::compare
