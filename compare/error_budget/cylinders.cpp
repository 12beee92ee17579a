// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>

#include "compare/bodies/closed_forms.h"
#include "compare/error_budget/bodies.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"

// A chord e lies e^2 / 12 inside its circle of radius 1 on the mean, and is shorter than its arc by e^2 / 24 of it. The
// side's triangles have their barycentres at a third of the chord: e^2 / 9 inside, second moment e^2 / 18.
namespace pcm::compare {
namespace {

constexpr double kRadius = 1;
constexpr double kLength = 1;
constexpr double kDepth = 0.05;
constexpr double kDisplacement = 0.02;
constexpr double kPi = static_cast<double>(closed_forms::kPi);

Index segments(std::size_t level) {
  return Index{64} << level;
}

double chord(std::size_t level) {
  return 2 * kRadius * std::sin(kPi / segments(level));
}

/// How much larger a circle's inscribed polygon must be to enclose its area.
double factor_of_equal_area(Index n) {
  return std::sqrt(2 * kPi / (n * std::sin(2 * kPi / n)));
}

TriangleMesh cylinder(std::size_t level) {
  return generate::cylinder(kRadius, kLength, segments(level));
}

/// Equal in cross-section, and so in volume.
TriangleMesh filled_cylinder(std::size_t level) {
  return generate::cylinder(kRadius * factor_of_equal_area(segments(level)), kLength, segments(level));
}

/// The cylinder's ends lie over grid lines of the plate, which is longer.
TriangleMesh plate(std::size_t level) {
  return generate::plate(1.5, 2 * kLength, 1, segments(level) / 4, 4);
}

TriangleMesh bore(std::size_t level) {
  return generate::tube(kRadius, 2 * kRadius, 2 * kLength, 2 * segments(level), 4);
}

TriangleMesh filled_bore(std::size_t level) {
  const double factor = factor_of_equal_area(2 * segments(level));
  return generate::tube(kRadius * factor, 2 * kRadius * factor, 2 * kLength, 2 * segments(level), 4);
}

/// Turns the z axis into the y axis, exactly.
Eigen::Matrix3d lying() {
  Eigen::Matrix3d R;
  R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return R;
}

BudgetCase cylinder_on_plane(Extent extent) {
  BudgetCase pair;
  pair.id = "cylinder-on-plane";
  pair.title = "cylinder on plane";
  pair.problem = "cylinder, r = 1 m, 1 m long, rolled about its axis, pressed by 0.05 m into a gridded plate";
  pair.reference = "F / L = K 2r (r sin t - (r - h) t), cos t = 1 - h/r";
  pair.levels = budget_levels(extent);
  pair.width = 2 * std::sqrt(2 * kRadius * kDepth - kDepth * kDepth);
  pair.in_words = [](std::size_t level) {
    return fmt::format("{} segments, plate {} x 4", segments(level), segments(level) / 4);
  };
  pair.edge = chord;
  pair.meshes = [](std::size_t level) { return BudgetMeshes{cylinder(level), plate(level)}; };
  pair.equal_volume = [](std::size_t level) { return BudgetMeshes{filled_cylinder(level), plate(level)}; };
  pair.placement = [](int i) {
    const double x = 0.618 * i;
    return Placement{lying() * fixed_roll(i), {0.1 * (x - std::floor(x)), 0, kRadius - kDepth}};
  };
  const auto force = static_cast<double>(closed_forms::cylinder_on_plane_cylinder_master(kRadius, kDepth));
  pair.force_F = [force](int) { return Eigen::Vector3d(0, 0, kLength * force); };

  const double e = chord(pair.levels - 1), sine = pair.width / 2;
  const double border = e * e * sine / 18 / force, geometry = -e * e * (sine / 6 / force + 1.0 / 24);
  pair.discretisation = second_order(-border, 0.1 * border, extent, "leading term, the border's");
  pair.one_pose = no_more_than(1.5 * border, "the leading term, and scatter");
  pair.geometry = second_order(geometry, -0.05 * geometry, extent, "leading term of the inscribed polygon");
  pair.geometry_equal_volume =
      no_more_than(e * e / 4, "the depth's part is gone, that of the arc, of order e^2, is left");
  return pair;
}

BudgetCase journal_in_bore(Extent extent) {
  BudgetCase pair;
  pair.id = "journal-in-bore";
  pair.title = "journal in bore";
  pair.problem =
      "cylinder, r = 1 m, 1 m long, rolled about its axis, displaced by 0.02 m across a bore of the same radius, twice "
      "as "
      "fine";
  pair.reference = "integral of the penetration over the journal's arc, by quadrature";
  pair.levels = budget_levels(extent);
  pair.width = kPi * kRadius;
  pair.in_words = [](std::size_t level) {
    return fmt::format("{} segments, bore {}", segments(level), 2 * segments(level));
  };
  pair.edge = chord;
  pair.meshes = [](std::size_t level) { return BudgetMeshes{cylinder(level), bore(level)}; };
  pair.equal_volume = [](std::size_t level) { return BudgetMeshes{filled_cylinder(level), filled_bore(level)}; };
  pair.placement = [](int i) { return Placement{fixed_roll(i), {kDisplacement, 0, 0}}; };
  const auto force = static_cast<double>(closed_forms::journal_in_bore_journal_master(kRadius, kRadius, kDisplacement));
  pair.force_F = [force](int) { return Eigen::Vector3d(-kLength * force, 0, 0); };

  // The bore's chords, half as long, lie a quarter as far inside the bore; all of it counts over the projected arc.
  const auto t = static_cast<double>(closed_forms::ball_contact_angle(kRadius, kRadius, kDisplacement));
  const double e = chord(pair.levels - 1), over = 2 * std::sin(t) * e * e / force;
  const double curvature = -over / 36, geometry = -over * (1 - 0.25) / 12;
  pair.discretisation = second_order(curvature, -0.05 * curvature, extent, "leading term, the bore's curvature");
  pair.one_pose = no_more_than(-1.5 * curvature, "the leading term, and scatter");
  pair.geometry = second_order(geometry, -0.05 * geometry, extent, "leading terms, journal and bore");
  pair.geometry_equal_volume = no_more_than(e * e / 2, "the gaps even out, terms of order e^2 of the force are left");
  return pair;
}

}  // namespace

std::vector<BudgetCase> budget_of_cylinders(Extent extent) {
  return {cylinder_on_plane(extent), journal_in_bore(extent)};
}

}  // namespace pcm::compare
