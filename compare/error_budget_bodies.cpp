// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/error_budget_bodies.h"

#include <Eigen/Geometry>
#include <cmath>

#include "compare/closed_forms.h"
#include "compare/identity_support.h"
#include "meshes/generate_boxes.h"
#include "meshes/generate_bubbles.h"
#include "meshes/generate_parts.h"
#include "meshes/generate_round.h"

namespace pcm::compare {
namespace {

constexpr double kRadius = 1;
constexpr double kDepth = 0.05;
constexpr double kHollow = 1.01;
constexpr double kDisplacement = 0.02;
constexpr double kBubble = 0.40;
constexpr double kBubbleDepth = 0.01;
constexpr double kPi = static_cast<double>(closed_forms::kPi);

Index refinements(std::size_t level) {
  return static_cast<Index>(level) + 3;
}

TriangleMesh sphere(std::size_t level) {
  return generate::icosphere(kRadius, refinements(level));
}

TriangleMesh hollow(std::size_t level) {
  const Index bands = Index{8} << level;
  return generate::socket(kHollow, 0.5, 4 * bands, bands);
}

TriangleMesh plate(std::size_t level) {
  const Index cells = Index{10} << level;
  return generate::plate(1.5, 1.5, 1.5, cells, cells);
}

/// Volume between the origin and those faces that lie on the sphere of this radius, m^3.
double volume_under(const TriangleMesh& mesh, double radius) {
  const auto on_sphere = [&](Index v) {
    return std::abs(mesh.vertices[static_cast<std::size_t>(v)].norm() - radius) < 1e-9 * radius;
  };
  double six_volumes = 0;
  for (const auto& [a, b, c] : mesh.faces)
    if (on_sphere(a) && on_sphere(b) && on_sphere(c))
      six_volumes += std::abs(mesh.vertices[static_cast<std::size_t>(a)].dot(
          mesh.vertices[static_cast<std::size_t>(b)].cross(mesh.vertices[static_cast<std::size_t>(c)])));
  return six_volumes / 6;
}

/// The mesh about the origin made larger until what lies under its faces on the sphere is the smooth body's volume.
TriangleMesh filled(TriangleMesh mesh, double radius, double smooth_volume) {
  const double factor = std::cbrt(smooth_volume / volume_under(mesh, radius));
  for (Eigen::Vector3d& x : mesh.vertices) x *= factor;
  return mesh;
}

TriangleMesh filled_sphere(std::size_t level) {
  return filled(sphere(level), kRadius, 4 * kPi / 3 * kRadius * kRadius * kRadius);
}

TriangleMesh filled_hollow(std::size_t level) {
  return filled(hollow(level), kHollow, 2 * kPi / 3 * kHollow * kHollow * kHollow);
}

/// The direction from F to E, for bodies that present another side of F in every orientation.
Eigen::Vector3d direction(int orientation) {
  return fixed_rotation((orientation + 7) % kOrientations).col(2);
}

/// The same surface with each face split in four `level` times.
TriangleMesh finer_bubble(std::size_t level) {
  TriangleMesh mesh = generate::bubble(kBubble);
  for (std::size_t i = 0; i < level; ++i) mesh = split(mesh);
  return mesh;
}

/// Along the direction, pressed in by kBubbleDepth from a distance at which the bubbles begin to touch.
Placement pressed_bubbles(const fast::Pairing& pairing, int orientation) {
  Placement placement{fixed_rotation(orientation), {}};
  fast::Workspace workspace;
  Wanted nothing;
  nothing.polygons = nothing.areas = nothing.force = nothing.elements = false;
  double touching = 0, apart = 1.25 * kBubble;
  for (int halving = 0; halving < 24; ++halving) {
    const double middle = (touching + apart) / 2;
    placement.p = middle * direction(orientation);
    (fast::evaluate(pairing, placement.pose(), {}, nothing, workspace).touching ? touching : apart) = middle;
  }
  placement.p = (touching - kBubbleDepth) * direction(orientation);
  return placement;
}

BudgetCase sphere_on_plane() {
  BudgetCase pair;
  pair.title = "sphere on plane";
  pair.problem = "icosphere, r = 1 m, pressed by 0.05 m into a gridded plate; closed form pi r h^2";
  pair.meshes = [](std::size_t level) { return BudgetMeshes{sphere(level), plate(level)}; };
  pair.equal_volume = [](std::size_t level) { return BudgetMeshes{filled_sphere(level), plate(level)}; };
  pair.placement = [](int i) {
    const double x = 0.618 * i, y = 0.755 * i;
    return Placement{fixed_rotation(i), {0.1 * (x - std::floor(x)), 0.1 * (y - std::floor(y)), kRadius - kDepth}};
  };
  pair.axis_F = [](int) { return Eigen::Vector3d(0, 0, 1); };
  pair.reference = closed_forms::sphere_on_plane_sphere_master(kRadius, kDepth);
  pair.width = 2 * std::sqrt(2 * kRadius * kDepth - kDepth * kDepth);
  return pair;
}

BudgetCase sphere_on_sphere() {
  BudgetCase pair;
  pair.title = "sphere on sphere";
  pair.problem = "icospheres, r = 1 m, pressed by 0.1 m into each other; closed form by quadrature";
  pair.meshes = [](std::size_t level) { return BudgetMeshes{sphere(level), sphere(level)}; };
  pair.equal_volume = [](std::size_t level) { return BudgetMeshes{filled_sphere(level), filled_sphere(level)}; };
  const double distance = 2 * kRadius - 2 * kDepth;
  pair.placement = [distance](int i) { return Placement{fixed_rotation(i), distance * direction(i)}; };
  pair.axis_F = direction;
  pair.reference = closed_forms::sphere_on_sphere(kRadius, kRadius, distance);
  pair.width = 2 * std::sqrt(kRadius * kRadius - distance * distance / 4);
  return pair;
}

BudgetCase ball_in_socket() {
  BudgetCase pair;
  pair.title = "ball in socket";
  pair.problem = "icosphere, r = 1 m, displaced by 0.02 m in a hollow of R = 1.01 m; closed form by quadrature";
  pair.meshes = [](std::size_t level) { return BudgetMeshes{sphere(level), hollow(level)}; };
  pair.equal_volume = [](std::size_t level) { return BudgetMeshes{filled_sphere(level), filled_hollow(level)}; };
  pair.placement = [](int i) { return Placement{fixed_rotation(i), {0, 0, -kDisplacement}}; };
  pair.axis_F = [](int) { return Eigen::Vector3d(0, 0, 1); };
  pair.reference = closed_forms::sphere_in_socket_sphere_master(kRadius, kHollow, kDisplacement);
  pair.width = 2 * kRadius * static_cast<double>(closed_forms::ball_contact_angle(kRadius, kHollow, kDisplacement));
  return pair;
}

BudgetCase bubble_on_bubble() {
  BudgetCase pair;
  pair.title = "bubble on bubble";
  pair.problem =
      "the paper's bubbles of 0.40 m, pressed by 0.01 m into each other; the master's faces split in four at each "
      "level, the slave's 950 faces kept";
  pair.meshes = [](std::size_t level) { return BudgetMeshes{finer_bubble(level), generate::bubble(kBubble)}; };
  const fast::Surface bubble(generate::bubble(kBubble));
  pair.placement = [pairing = fast::Pairing(bubble, bubble)](int i) { return pressed_bubbles(pairing, i); };
  return pair;
}

}  // namespace

std::vector<BudgetCase> budget_cases(std::size_t levels) {
  std::vector<BudgetCase> cases{sphere_on_plane(), sphere_on_sphere(), ball_in_socket(), bubble_on_bubble()};
  for (BudgetCase& pair : cases) pair.levels = levels;
  return cases;
}

}  // namespace pcm::compare
