// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/orientation_margin.h"

#include <cmath>

#include "meshes/exact/dyadic.h"

namespace pcm::compare {
namespace {

using ExactVector = std::array<Dyadic, 3>;

ExactVector difference(const Eigen::Vector3d& to, const Eigen::Vector3d& from) {
  return {Dyadic(to.x()) - Dyadic(from.x()), Dyadic(to.y()) - Dyadic(from.y()), Dyadic(to.z()) - Dyadic(from.z())};
}

}  // namespace

double orientation_margin(const std::array<Eigen::Vector3d, 4>& points) {
  const auto& [a, b, c, d] = points;
  const ExactVector p = difference(b, a), q = difference(c, a), s = difference(d, a);
  const double determinant =
      ((p[1] * q[2] - p[2] * q[1]) * s[0] + (p[2] * q[0] - p[0] * q[2]) * s[1] + (p[0] * q[1] - p[1] * q[0]) * s[2])
          .approximate();
  const Eigen::Vector3d P = (b - a).cwiseAbs(), Q = (c - a).cwiseAbs(), S = (d - a).cwiseAbs();
  const double terms =
      (P[1] * Q[2] + P[2] * Q[1]) * S[0] + (P[2] * Q[0] + P[0] * Q[2]) * S[1] + (P[0] * Q[1] + P[1] * Q[0]) * S[2];
  return terms > 0 ? std::abs(determinant) / terms : 0;
}

}  // namespace pcm::compare
