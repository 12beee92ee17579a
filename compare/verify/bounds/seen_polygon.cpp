// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/bounds/seen_polygon.h"

#include <cmath>

namespace pcm::compare {

double outline_of(const std::vector<SeenPoint>& polygon) {
  double outline = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    outline += (polygon[(i + 1) % polygon.size()] - polygon[i]).head<2>().stableNorm();
  return outline;
}

double area_of(const std::vector<SeenPoint>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SeenPoint a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
    twice += cross(a, b);
  }
  return twice / 2;
}

double area_near_zero(const std::vector<SeenPoint>& polygon, double error) {
  const auto not_below = cut(polygon, [&](const SeenPoint& x) { return x.z() + error; });
  return std::abs(area_of(cut(not_below, [&](const SeenPoint& x) { return error - x.z(); })));
}

Eigen::Vector2d inward_of_side(const SeenFace& face, std::size_t k) {
  const double sign = cross(face[1] - face[0], face[2] - face[0]) < 0 ? -1 : 1;
  const Eigen::Vector2d along = (face[(k + 1) % 3] - face[k]).head<2>();
  const double length = along.stableNorm();
  if (!(length > 0)) return Eigen::Vector2d::Zero();
  return sign / length * Eigen::Vector2d(-along.y(), along.x());
}

std::vector<SeenPoint> within(std::vector<SeenPoint> polygon, const SeenFace& face, double margin) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector2d inward = inward_of_side(face, k);
    polygon = cut(polygon, [&](const SeenPoint& x) { return inward.dot((x - face[k]).head<2>()) + margin; });
  }
  return polygon;
}

}  // namespace pcm::compare
