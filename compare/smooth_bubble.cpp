// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/smooth_bubble.h"

#include <cmath>
#include <vector>

#include "compare/closed_forms.h"
#include "compare/random.h"

namespace pcm::compare {
namespace {

constexpr double kPi = static_cast<double>(closed_forms::kPi);

/// How far a point lies inside the smooth bubble in the direction of the origin; negative outside.
double inside(const Eigen::Vector3d& y, double length) {
  const double square = ordered_dot(y, y);
  return length / 3 * (0.5 + y.z() * y.z() / square) - std::sqrt(square);
}

/// The way from y along the unit direction m to the bubble's surface. |gradient of `inside`| is below 2 where it is
/// less than a third of the distance from the origin, so half of it can't overshoot.
double way_out(Eigen::Vector3d y, const Eigen::Vector3d& m, double length) {
  double way = 0;
  for (double left = inside(y, length); left > 1e-9 * length; left = inside(y, length)) {
    way += left / 2;
    y += left / 2 * m;
  }
  return way;
}

}  // namespace

double smooth_bubble_volume(double length) {
  const double third = length / 3;
  return 2 * kPi / 3 * third * third * third * 229 / 140;
}

Eigen::Vector3d smooth_bubble_force(double length, const Placement& placement, int cells) {
  const double step = kPi / cells;
  std::vector<Eigen::Vector2d> around;
  for (int k = 0; k < 2 * cells; ++k) around.emplace_back(std::cos((k + 0.5) * step), std::sin((k + 0.5) * step));
  const double farthest = length / 2;  // of F's surface from its origin
  Eigen::Vector3d sum_F = Eigen::Vector3d::Zero();
  for (int j = 0; j < cells; ++j) {
    const double cosine = std::cos((j + 0.5) * step), sine = std::sin((j + 0.5) * step);
    const double distance = length / 3 * (0.5 + cosine * cosine), slope = -length / 3 * 2 * sine * cosine;
    // The normal, as long as the area element, is sin t (distance e_r - slope e_t) distance.
    const double radial = distance * sine - slope * cosine, axial = distance * cosine + slope * sine;
    const double size = std::sqrt(radial * radial + axial * axial);
    for (const Eigen::Vector2d& turn : around) {
      const Eigen::Vector3d y =
          placement.p +
          ordered_product(placement.R, {distance * sine * turn.x(), distance * sine * turn.y(), distance * cosine});
      if (ordered_dot(y, y) >= farthest * farthest || inside(y, length) <= 0) continue;
      const Eigen::Vector3d n =
          ordered_product(placement.R, {radial / size * turn.x(), radial / size * turn.y(), axial / size});
      sum_F -= way_out(y, -n, length) * size * distance * sine * n;
    }
  }
  return step * step * sum_F;
}

}  // namespace pcm::compare
