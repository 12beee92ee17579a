// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/files/triangulate_polygon.h"

#include <Eigen/Geometry>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "meshes/exact/exact_signs.h"

namespace pcm {
namespace {

/// The polygon in the plane, turned so that it runs counterclockwise; empty where it has no area.
std::vector<Eigen::Vector2d> project(const std::vector<Eigen::Vector3d>& vertices, std::span<const Index> corners) {
  const Eigen::Vector3d& origin = vertices[corners[0]];
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += (vertices[corners[i]] - origin).cross(vertices[corners[i + 1]] - origin);

  // Largest component first; the others are tried where the exact area vanishes in its plane.
  std::array<int, 3> axes{0, 1, 2};
  const auto put_larger_first = [&](int& a, int& b) {
    if (std::abs(normal[b]) > std::abs(normal[a])) std::swap(a, b);
  };
  put_larger_first(axes[1], axes[2]);
  put_larger_first(axes[0], axes[1]);
  put_larger_first(axes[1], axes[2]);

  std::vector<Eigen::Vector2d> points(corners.size());
  for (const int axis : axes) {
    for (std::size_t i = 0; i < corners.size(); ++i) points[i] = without_axis(vertices[corners[i]], axis);
    const int orientation = area_sign(points);
    if (orientation == 0) continue;
    if (orientation < 0)
      for (Eigen::Vector2d& point : points) std::swap(point.x(), point.y());
    return points;
  }
  return {};
}

/// Whether the fan from the first point consists of counterclockwise triangles and no corner turns clockwise.
bool is_convex(const std::vector<Eigen::Vector2d>& points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turn_sign(points[i], points[(i + 1) % n], points[(i + 2) % n]) < 0) return false;
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (turn_sign(points[0], points[i], points[i + 1]) <= 0) return false;
  return true;
}

/// What is left of a polygon while its ears are clipped: a ring of corners, linked both ways.
class Ring {
 public:
  explicit Ring(const std::vector<Eigen::Vector2d>& points)
      : points_(points), previous_(points.size()), next_(points.size()) {
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      previous_[next_[i]] = i;
    }
  }

  std::size_t next(std::size_t i) const { return next_[i]; }
  std::size_t previous(std::size_t i) const { return previous_[i]; }

  void remove(std::size_t i) {
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
  }

  int turn(std::size_t i) const { return turn_sign(points_[previous_[i]], points_[i], points_[next_[i]]); }

  /// Whether corner i is strictly convex and its triangle, border included, holds no other corner. Only corners that
  /// aren't strictly convex need a look; those that coincide with one of the triangle's (a slit cut to a hole) pass.
  bool is_ear(std::size_t i) const {
    if (turn(i) <= 0) return false;
    const Eigen::Vector2d& a = points_[previous_[i]];
    const Eigen::Vector2d& b = points_[i];
    const Eigen::Vector2d& c = points_[next_[i]];
    const Eigen::Vector2d low = a.cwiseMin(b).cwiseMin(c);
    const Eigen::Vector2d high = a.cwiseMax(b).cwiseMax(c);
    for (std::size_t j = next_[next_[i]]; j != previous_[i]; j = next_[j]) {
      const Eigen::Vector2d& p = points_[j];
      if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) continue;
      if (p == a || p == b || p == c || turn(j) > 0) continue;
      if (turn_sign(a, b, p) >= 0 && turn_sign(b, c, p) >= 0 && turn_sign(c, a, p) >= 0) return false;
    }
    return true;
  }

 private:
  const std::vector<Eigen::Vector2d>& points_;
  std::vector<std::size_t> previous_;
  std::vector<std::size_t> next_;
};

/// The first ear from `start` on; a strictly convex corner, or else any, where the polygon is not simple and has none.
std::size_t find_ear(const Ring& ring, std::size_t start, std::size_t left) {
  std::size_t i = start;
  for (std::size_t k = 0; k < left; ++k, i = ring.next(i))
    if (ring.is_ear(i)) return i;
  for (std::size_t k = 0; k < left; ++k, i = ring.next(i))
    if (ring.turn(i) > 0) return i;
  return start;
}

void clip_ears(const std::vector<Eigen::Vector2d>& points, std::span<const Index> corners,
               std::vector<Triangle>& faces) {
  // In a simple polygon only the neighbours of a clipped ear can become ears, so every corner is tried once and they
  // once more each time. One that touches itself may hide an ear from this; then all corners are searched.
  Ring ring(points);
  std::vector<std::size_t> to_try(points.size());
  std::iota(to_try.begin(), to_try.end(), std::size_t{0});
  std::vector<bool> clipped(points.size(), false);
  std::size_t tried = 0;
  std::size_t last = 0;  // a corner that is still there
  for (std::size_t left = points.size(); left > 3;) {
    std::size_t ear = 0;
    if (tried < to_try.size()) {
      ear = to_try[tried++];
      if (clipped[ear] || !ring.is_ear(ear)) continue;
    } else {
      ear = find_ear(ring, last, left);
    }
    faces.push_back({corners[ring.previous(ear)], corners[ear], corners[ring.next(ear)]});
    to_try.push_back(ring.previous(ear));
    to_try.push_back(ring.next(ear));
    last = ring.next(ear);
    clipped[ear] = true;
    ring.remove(ear);
    --left;
  }
  faces.push_back({corners[ring.previous(last)], corners[last], corners[ring.next(last)]});
}

}  // namespace

void triangulate_polygon(const std::vector<Eigen::Vector3d>& vertices, std::span<const Index> corners,
                         std::vector<Triangle>& faces) {
  assert(corners.size() >= 3);
  if (corners.size() == 3) {
    faces.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  const std::vector<Eigen::Vector2d> points = project(vertices, corners);
  if (!points.empty() && !is_convex(points)) {
    clip_ears(points, corners, faces);
    return;
  }
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) faces.push_back({corners[0], corners[i], corners[i + 1]});
}

}  // namespace pcm
