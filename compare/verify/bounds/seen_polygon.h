// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

/// Faces and convex polygons as a master face sees them: every point by two lengths in the master's plane and its
/// depth. Lengths, areas and directions here are those in the plane.
namespace pcm::compare {

/// In lengths along two directions at right angles in the master's plane, m, and a depth, m, which other linear
/// functions of the point may stand for.
using SeenPoint = Eigen::Vector3d;
using SeenFace = std::array<SeenPoint, 3>;

inline double cross(const SeenPoint& a, const SeenPoint& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The border of a polygon, m.
double outline_of(const std::vector<SeenPoint>& polygon);

/// The area of a polygon, m^2, > 0 where it is counterclockwise.
double area_of(const std::vector<SeenPoint>& polygon);

/// Where |z| is no more than the error of z, so that its sign may be mistaken, m^2.
double area_near_zero(const std::vector<SeenPoint>& polygon, double error);

/// The direction from a face's side k inward, of unit length; null for a side without length, which bounds nothing.
Eigen::Vector2d inward_of_side(const SeenFace& face, std::size_t k);

/// The part of a convex polygon over a face that is grown by `margin`.
std::vector<SeenPoint> within(std::vector<SeenPoint> polygon, const SeenFace& face, double margin);

/// The part of a convex polygon where a linear function of the point is not negative.
template <class Height>
std::vector<SeenPoint> cut(const std::vector<SeenPoint>& polygon, const Height& height) {
  std::vector<SeenPoint> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SeenPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = height(a), at_b = height(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

/// Whether `all_beyond(k, is_beyond)` holds for a side k of the face: `is_beyond` says of a point whether it lies on
/// the far side of that one by more than `strip`.
template <class AllBeyond>
bool some_side_parts(const SeenFace& face, double strip, const AllBeyond& all_beyond) {
  const double sign = cross(face[1] - face[0], face[2] - face[0]) < 0 ? -1 : 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const SeenPoint along = face[(k + 1) % 3] - face[k];
    const double error = strip * along.head<2>().stableNorm();
    if (all_beyond(k, [&](const SeenPoint& x) { return sign * cross(along, x - face[k]) < -error; })) return true;
  }
  return false;
}

}  // namespace pcm::compare
