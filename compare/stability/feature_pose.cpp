// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/feature_pose.h"

#include <algorithm>
#include <array>

#include "compare/poses/opposed_rotation.h"
#include "reference/numbers/ball.h"

namespace pcm::compare::stability {
namespace {

using reference::Rational;

using ExactPoint = std::array<Rational, 3>;

std::array<Eigen::Vector3d, 3> corners(const TriangleMesh& mesh, std::size_t face) {
  std::array<Eigen::Vector3d, 3> points;
  for (std::size_t k = 0; k < 3; ++k)
    points[k] = mesh.vertices[static_cast<std::size_t>(mesh.faces[face][static_cast<int>(k)])];
  return points;
}

Eigen::Vector3d doubled_normal(const std::array<Eigen::Vector3d, 3>& p) {
  return ordered_cross(p[1] - p[0], p[2] - p[0]);
}

ExactPoint weighted(const std::array<Eigen::Vector3d, 3>& p, const std::array<Rational, 3>& weights) {
  ExactPoint point;
  for (int i = 0; i < 3; ++i) {
    point[static_cast<std::size_t>(i)] = 0;
    for (std::size_t k = 0; k < 3; ++k) point[static_cast<std::size_t>(i)] += weights[k] * Rational(p[k][i]);
  }
  return point;
}

double longest_edge(const std::array<Eigen::Vector3d, 3>& p) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d edge = p[(k + 1) % 3] - p[k];
    longest = std::max(longest, std::sqrt(ordered_dot(edge, edge)));
  }
  return longest;
}

/// Where on F, which way is out there, and how far F is tilted about that.
struct Drawn {
  ExactPoint point;
  Eigen::Vector3d normal;
  double tangent = 0;
};

Drawn draw_on_face(const TriangleMesh& mesh, double depth, PoseRandom& random) {
  const auto p = corners(mesh, random.below(mesh.faces.size()));
  const Rational a(random.uniform(0.25, 0.375)), b(random.uniform(0.25, 0.375));
  Drawn drawn{weighted(p, {a, b, Rational(1) - a - b}), ordered_normalized(doubled_normal(p)), 0};
  drawn.tangent = std::min(depth / longest_edge(p), 0.25) * random.uniform(0.25, 1);
  return drawn;
}

Drawn draw_vertex(const TriangleMesh& mesh, PoseRandom& random) {
  const auto v = static_cast<Index>(random.below(mesh.vertices.size()));
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (std::find(mesh.faces[f].begin(), mesh.faces[f].end(), v) != mesh.faces[f].end())
      normal += ordered_normalized(doubled_normal(corners(mesh, f)));
  const Eigen::Vector3d& x = mesh.vertices[static_cast<std::size_t>(v)];
  return {{Rational(x[0]), Rational(x[1]), Rational(x[2])}, ordered_normalized(normal), random.uniform(0, 0.1)};
}

}  // namespace

Pose draw_feature_pose(const SweptBodies& bodies, PoseRandom random) {
  const auto p_E = corners(bodies.E, random.below(bodies.E.faces.size()));
  const Eigen::Vector3d n_E = ordered_normalized(doubled_normal(p_E));
  const Drawn on_F =
      bodies.feature == Feature::face ? draw_on_face(bodies.F, bodies.depth, random) : draw_vertex(bodies.F, random);
  Pose pose;
  pose.A = draw_opposed_rotation(n_E, on_F.normal, on_F.tangent / 2, random);
  const Rational third = Rational(1) / Rational(3);
  const ExactPoint barycentre = weighted(p_E, {third, third, third});
  for (int i = 0; i < 3; ++i) {
    Rational r = barycentre[static_cast<std::size_t>(i)] - Rational(n_E[i]) * Rational(bodies.depth);
    for (int j = 0; j < 3; ++j) r -= Rational(pose.A(i, j)) * on_F.point[static_cast<std::size_t>(j)];
    pose.r[i] = reference::nearest_double(r);
  }
  return pose;
}

}  // namespace pcm::compare::stability
