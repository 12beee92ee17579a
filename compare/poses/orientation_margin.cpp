// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/orientation_margin.h"

#include <cmath>

#include "fast/base/number_vector.h"

namespace pcm::compare {

double orientation_margin(const std::array<Eigen::Vector3d, 4>& points) {
  const auto& [a, b, c, d] = points;
  const auto from_a = [&a = a](const Eigen::Vector3d& x) { return fast::difference<Dyadic>(x.data(), a.data()); };
  const double determinant = dot(cross(from_a(b), from_a(c)), from_a(d)).approximate();
  const Eigen::Vector3d P = (b - a).cwiseAbs(), Q = (c - a).cwiseAbs(), S = (d - a).cwiseAbs();
  const double terms =
      (P[1] * Q[2] + P[2] * Q[1]) * S[0] + (P[2] * Q[0] + P[0] * Q[2]) * S[1] + (P[0] * Q[1] + P[1] * Q[0]) * S[2];
  return terms > 0 ? std::abs(determinant) / terms : 0;
}

}  // namespace pcm::compare
