// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/bodies/smooth_bubble.h"

#include <cmath>
#include <vector>

#include "compare/bodies/closed_forms.h"
#include "compare/random/random.h"

namespace pcm::compare {
namespace {

constexpr double kPi = static_cast<double>(closed_forms::kPi);

/// How far a point lies inside the smooth bubble in the direction of the origin; negative outside.
double inside(const Eigen::Vector3d& y, double length) {
  const double square = ordered_dot(y, y);
  return length / 3 * (0.5 + y.z() * y.z() / square) - std::sqrt(square);
}

/// The point where the way from y along the unit direction m leaves the bubble. |gradient of `inside`| is below 2 where
/// it is less than a third of the distance from the origin, so half of it can't overshoot.
Eigen::Vector3d way_out(Eigen::Vector3d y, const Eigen::Vector3d& m, double length) {
  for (double left = inside(y, length); left > 1e-9 * length; left = inside(y, length)) y += left / 2 * m;
  return y;
}

/// A meridian's point at the angle t from the axis.
struct MeridianPoint {
  MeridianPoint(double length, double cosine, double sine)
      : radius(length / 3 * (0.5 + cosine * cosine) * sine), z(length / 3 * (0.5 + cosine * cosine) * cosine) {
    const double d = length / 3 * (0.5 + cosine * cosine), first = -length / 3 * 2 * sine * cosine;
    const double second = -length / 3 * 2 * (cosine * cosine - sine * sine);
    speed = std::sqrt(d * d + first * first);
    normal_radius = (d * sine - first * cosine) / speed;
    normal_z = (d * cosine + first * sine) / speed;
    curvature = (d * d + 2 * first * first - d * second) / (speed * speed * speed);
    support = d * d / speed;
  }

  double radius;         ///< from the axis, m
  double z;              ///< along it, m
  double speed;          ///< of the arc length, m
  double normal_radius;  ///< outward unit normal
  double normal_z;
  double curvature;  ///< of the meridian, 1/m
  double support;    ///< x . n, m
};

/// A point of E's surface inside F.
struct ContactPoint {
  MeridianPoint on_E;
  double area = 0;  ///< that it stands for, m^2
  Eigen::Vector3d n_F = Eigen::Vector3d::Zero();
  Eigen::Vector3d at_F = Eigen::Vector3d::Zero();
  Eigen::Vector3d out_F = Eigen::Vector3d::Zero();  ///< where the way along -n leaves F
};

template <class Visit>
void over_contact(double length, const Placement& placement, int cells, const Visit& visit) {
  const double step = kPi / cells;
  std::vector<Eigen::Vector2d> around;
  for (int k = 0; k < 2 * cells; ++k) around.emplace_back(std::cos((k + 0.5) * step), std::sin((k + 0.5) * step));
  const double farthest = length / 2;  // of F's surface from its origin
  for (int j = 0; j < cells; ++j) {
    const MeridianPoint on_E(length, std::cos((j + 0.5) * step), std::sin((j + 0.5) * step));
    for (const Eigen::Vector2d& turn : around) {
      const Eigen::Vector3d y =
          placement.p + ordered_product(placement.R, {on_E.radius * turn.x(), on_E.radius * turn.y(), on_E.z});
      if (ordered_dot(y, y) >= farthest * farthest || inside(y, length) <= 0) continue;
      const Eigen::Vector3d n =
          ordered_product(placement.R, {on_E.normal_radius * turn.x(), on_E.normal_radius * turn.y(), on_E.normal_z});
      visit(ContactPoint{on_E, step * step * on_E.radius * on_E.speed, n, y, way_out(y, -n, length)});
    }
  }
}

/// How far the mesh's faces lie inside the surface there, m.
double inset(const MeridianPoint& at, Index finer) {
  const double a = at.speed * kPi / (20 * finer), b = at.radius * 2 * kPi / (25 * finer);
  return (at.curvature * a * a + at.normal_radius / at.radius * b * b) / 12;
}

/// By what part of itself the mesh must grow to enclose the smooth volume, to leading order.
double growth(double length, Index finer) {
  constexpr int kSteps = 1000;
  double lost = 0;
  for (int j = 0; j < kSteps; ++j) {
    const double t = kPi * (j + 0.5) / kSteps;
    const MeridianPoint at(length, std::cos(t), std::sin(t));
    lost += inset(at, finer) * 2 * kPi * at.radius * at.speed * kPi / kSteps;
  }
  return lost / (3 * smooth_bubble_volume(length));
}

}  // namespace

double smooth_bubble_volume(double length) {
  const double third = length / 3;
  return 2 * kPi / 3 * third * third * third * 229 / 140;
}

Eigen::Vector3d smooth_bubble_force(double length, const Placement& placement, int cells) {
  Eigen::Vector3d sum_F = Eigen::Vector3d::Zero();
  over_contact(length, placement, cells,
               [&](const ContactPoint& point) { sum_F -= (point.out_F - point.at_F).norm() * point.area * point.n_F; });
  return sum_F;
}

Eigen::Vector3d force_lost_to_meshes(double length, const Placement& placement, const BubbleMesh& mesh, int cells) {
  const double grown = mesh.equal_volume ? growth(length, mesh.finer) : 0;
  const auto lies_inside = [&](const MeridianPoint& at) { return inset(at, mesh.finer) - grown * at.support; };
  Eigen::Vector3d sum_F = Eigen::Vector3d::Zero();
  over_contact(length, placement, cells, [&](const ContactPoint& point) {
    const double distance = point.out_F.norm(), off_axis = std::hypot(point.out_F.x(), point.out_F.y());
    const MeridianPoint on_F(length, point.out_F.z() / distance, off_axis / distance);
    const Eigen::Vector3d n_F(on_F.normal_radius * point.out_F.x() / off_axis,
                              on_F.normal_radius * point.out_F.y() / off_axis, on_F.normal_z);
    const double cosine = std::abs(ordered_dot(n_F, point.n_F));
    sum_F -= (lies_inside(point.on_E) + lies_inside(on_F) / cosine) * point.area * point.n_F;
  });
  return sum_F;
}

}  // namespace pcm::compare
