// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bodies/polyhedral_foundation.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace pcm::compare {

namespace {

/// Integral over a triangle of unit area of the positive part of the linear function with the corner values
/// a >= b >= c. Where the triangle is cut, a corner of it is similar to a triangle with the values (a, 0, 0).
double integral(double a, double b, double c) {
  if (a <= 0) return 0;
  if (b <= 0) return a * a * a / (3 * (a - b) * (a - c));
  const double whole = (a + b + c) / 3;
  return c >= 0 ? whole : whole - c * c * c / (3 * (a - c) * (b - c));
}

/// Integral of its square, likewise.
double integral_of_square(double a, double b, double c) {
  if (a <= 0) return 0;
  if (b <= 0) return a * a * a * a / (6 * (a - b) * (a - c));
  const double whole = (a * a + b * b + c * c + a * b + b * c + c * a) / 6;
  return c >= 0 ? whole : whole - c * c * c * c / (6 * (a - c) * (b - c));
}

}  // namespace

PolyhedralFoundation::PolyhedralFoundation(const TriangleMesh& mesh, double stiffness, Scheme scheme)
    : stiffness_(stiffness) {
  for (const Triangle& t : mesh.faces) {
    const Eigen::Vector3d &p = mesh.vertices[t[0]], &q = mesh.vertices[t[1]], &s = mesh.vertices[t[2]];
    const Eigen::Vector3d normal = (q - p).cross(s - p);
    if (normal.z() >= 0) continue;
    Face face{normal.norm() / 2, {p.z(), q.z(), s.z()}};
    if (scheme == Scheme::barycentric) face.heights.fill((p.z() + q.z() + s.z()) / 3);
    std::sort(face.heights.begin(), face.heights.end());
    kinks_.insert(kinks_.end(), face.heights.begin(), face.heights.end());
    faces_.push_back(face);
  }
  std::sort(kinks_.begin(), kinks_.end());
  kinks_.erase(std::unique(kinks_.begin(), kinks_.end()), kinks_.end());
}

double PolyhedralFoundation::force(double plane) const {
  double sum = 0;
  for (const auto& [area, z] : faces_) sum += area * integral(plane - z[0], plane - z[1], plane - z[2]);
  return stiffness_ * sum;
}

double PolyhedralFoundation::work(double plane) const {
  double sum = 0;
  for (const auto& [area, z] : faces_) sum += area * integral_of_square(plane - z[0], plane - z[1], plane - z[2]);
  return stiffness_ * sum / 2;
}

}  // namespace pcm::compare
