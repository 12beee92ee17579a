// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/least_margin.h"

#include <cmath>
#include <limits>
#include <vector>

#include "compare/poses/orientation_margin.h"
#include "compare/poses/rounded_vertices.h"

namespace pcm::compare {
namespace {

/// The margin as doubles have it. The determinant of the differences is off by at most 8 * 2^-53 of what its terms add
/// up to (each is a product of three rounded differences, seven roundings and two sums), so the margin by 2^-50. NaN or
/// infinite where the terms leave the range of normal doubles.
double nearly_margin(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Eigen::Vector3d& d) {
  const Eigen::Vector3d p = b - a, q = c - a, s = d - a;
  const Eigen::Vector3d P = p.cwiseAbs(), Q = q.cwiseAbs(), S = s.cwiseAbs();
  const double terms =
      (P[1] * Q[2] + P[2] * Q[1]) * S[0] + (P[2] * Q[0] + P[0] * Q[2]) * S[1] + (P[0] * Q[1] + P[1] * Q[0]) * S[2];
  if (!(terms > 0x1p-900)) return std::numeric_limits<double>::quiet_NaN();
  const double determinant =
      (p[1] * q[2] - p[2] * q[1]) * s[0] + (p[2] * q[0] - p[0] * q[2]) * s[1] + (p[0] * q[1] - p[1] * q[0]) * s[2];
  return std::abs(determinant) / terms;
}

class LeastMargin {
 public:
  void consider(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                const Eigen::Vector3d& d) {
    constexpr double kRoundings = 0x1p-49;
    if (nearly_margin(a, b, c, d) > least_ + kRoundings) return;
    const double margin = orientation_margin({a, b, c, d});
    if (margin > 0 && margin < least_) least_ = margin;
  }

  void consider_heights(const std::vector<Eigen::Vector3d>& corners, const Triangle& face,
                        const std::vector<Eigen::Vector3d>& vertices) {
    const auto at = [&](std::size_t k) -> const Eigen::Vector3d& { return corners[static_cast<std::size_t>(face[k])]; };
    for (const Eigen::Vector3d& x : vertices) consider(at(0), at(1), at(2), x);
  }

  double value() const { return least_; }

 private:
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

double least_margin(const FeaturePair& pair, const Pose& pose) {
  const std::vector<Eigen::Vector3d> F = rounded_vertices(pair.F.mesh, pose);
  const std::vector<Eigen::Vector3d>& E = pair.E.mesh.vertices;
  LeastMargin least;
  for (const Triangle& face : pair.E.mesh.faces) least.consider_heights(E, face, F);
  for (const Triangle& face : pair.F.mesh.faces) least.consider_heights(F, face, E);
  for (const FeatureEdge& e : pair.E.edges)
    for (const FeatureEdge& f : pair.F.edges)
      least.consider(vertex(pair.E, e.ends[0]), vertex(pair.E, e.ends[1]), F[static_cast<std::size_t>(f.ends[0])],
                     F[static_cast<std::size_t>(f.ends[1])]);
  return least.value();
}

}  // namespace pcm::compare
