// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>

#include "compare/bodies/closed_forms.h"
#include "compare/error_budget/bodies.h"
#include "compare/random/random.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/parts.h"
#include "meshes/generate/round.h"

// The leading terms below are those of inscribed meshes of root mean square edge e, radius 1. A triangle of sides a, b,
// c lies (a^2 + b^2 + c^2) / 24 = e^2 / 8 inside the sphere on the mean, and its second moment in any direction is
// e^2 / 24 of its area on the mean over orientations; so
// - the clipped force changes by -e^2 / 8, times 1 / cos of the angle between the surfaces where the slave is
// concerned,
//   over the vector area of the contact;
// - the barycentric scheme gives what the clipped one does, plus e^2 / 48 times the Laplacian of the slave's surface
// over
//   the master's (for its barycentre stands for the whole face), less the border's part: where the penetration falls to
//   0 with a slope s, the integral of max(u, 0) over a face is not its value at the barycentre, which costs s e^2 / 48
//   a length of border.
namespace pcm::compare {
namespace {

constexpr double kRadius = 1;
constexpr double kDepth = 0.05;
constexpr double kSide = 1.5;
constexpr double kHollow = 1.01;
constexpr double kDisplacement = 0.02;
constexpr const char* kScatter = "the leading term, and scatter that falls with the 2.5th power of the edge";
constexpr double kPi = static_cast<double>(closed_forms::kPi);

Index refinements(std::size_t level) {
  return static_cast<Index>(level) + 3;
}

TriangleMesh sphere(std::size_t level) {
  return generate::icosphere(kRadius, refinements(level));
}

TriangleMesh filled_sphere(std::size_t level) {
  const TriangleMesh mesh = sphere(level);
  return scaled_to_volume(mesh, enclosed_volume(mesh), 4 * kPi / 3 * kRadius * kRadius * kRadius);
}

double sphere_edge(std::size_t level) {
  return mean_edge(sphere(level));
}

Index cells(std::size_t level) {
  return Index{10} << level;
}

TriangleMesh plate(std::size_t level) {
  return generate::plate(kSide, kSide, kSide, cells(level), cells(level));
}

/// Of the plate's top: cells of two right triangles.
double plate_edge(std::size_t level) {
  return kSide / cells(level) * std::sqrt(4.0 / 3);
}

Index bands(std::size_t level) {
  return Index{8} << level;
}

TriangleMesh hollow(std::size_t level) {
  return generate::socket(kHollow, 0.5, 4 * bands(level), bands(level));
}

/// Scaled until the hollow's faces, those whose vertices all lie on the sphere, enclose the smooth half ball.
TriangleMesh filled_hollow(std::size_t level) {
  const TriangleMesh mesh = hollow(level);
  double six_volumes = 0;
  const auto on_sphere = [&](Index v) { return std::abs(mesh.vertices[v].norm() / kHollow - 1) < 1e-9; };
  for (const auto& [a, b, c] : mesh.faces)
    if (on_sphere(a) && on_sphere(b) && on_sphere(c))
      six_volumes += std::abs(mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])));
  return scaled_to_volume(mesh, six_volumes / 6, 2 * kPi / 3 * kHollow * kHollow * kHollow);
}

std::string spheres_in_words(std::size_t level) {
  return fmt::format("icospheres {}", 20 << (2 * refinements(level)));
}

std::string sphere_and_plate_in_words(std::size_t level) {
  return fmt::format("icosphere {}, plate {} x {}", 20 << (2 * refinements(level)), cells(level), cells(level));
}

/// Of the sphere over the plate; its centre moves over a few cells with the orientation.
Placement pressed(int orientation) {
  const double x = 0.618 * orientation, y = 0.755 * orientation;
  return {fixed_rotation(orientation), {0.1 * (x - std::floor(x)), 0.1 * (y - std::floor(y)), kRadius - kDepth}};
}

/// Of F seen from E, where the argument is E's seen from F.
Placement seen_from_the_other(const Placement& placement) {
  const Eigen::Matrix3d inverse = placement.R.transpose();
  return {inverse, -ordered_product(inverse, placement.p)};
}

/// What the border of the contact takes from the barycentric scheme, relative, sphere on plane: its slope is sin t, its
/// length 2 pi sin t, the closed form pi h^2.
double border_of_sphere_on_plane(double edge) {
  return edge * edge * (2 * kDepth - kDepth * kDepth) / (24 * kDepth * kDepth);
}

BudgetCase sphere_on_plane(Extent extent) {
  BudgetCase pair;
  pair.id = "sphere-on-plane";
  pair.title = "sphere on plane";
  pair.problem = "icosphere, r = 1 m, pressed by 0.05 m into a gridded plate";
  pair.reference = "F = K pi r h^2";
  pair.levels = budget_levels(extent);
  pair.width = 2 * std::sqrt(2 * kRadius * kDepth - kDepth * kDepth);
  pair.in_words = sphere_and_plate_in_words;
  pair.edge = sphere_edge;
  pair.meshes = [](std::size_t level) { return BudgetMeshes{sphere(level), plate(level)}; };
  pair.equal_volume = [](std::size_t level) { return BudgetMeshes{filled_sphere(level), plate(level)}; };
  pair.placement = pressed;
  const auto force = static_cast<double>(closed_forms::sphere_on_plane_sphere_master(kRadius, kDepth));
  pair.force_F = [force](int) { return Eigen::Vector3d(0, 0, force); };

  const double e = sphere_edge(pair.levels - 1), border = border_of_sphere_on_plane(e);
  pair.discretisation = second_order(-border, 0.05 * border, extent, "leading term, the border's");
  pair.one_pose = no_more_than(1.5 * border, kScatter);
  // The triangles are smaller than the patches they stand for, by 5 e^2 / 24 of them.
  const double geometry = -e * e * (1 / (4 * kDepth) + 1.0 / 12);
  pair.geometry = second_order(geometry, -0.05 * geometry, extent, "leading term of the inscribed mesh");
  // Made larger by e^2 / 8 the mesh has the smooth one's depth on the mean, and an area larger by e^2 / 24.
  pair.geometry_equal_volume =
      no_more_than(e * e / 4, "the depth's part is gone, that of the area, of order e^2, is left");
  return pair;
}

/// The same contact with the plate as master: what the border of the contact loses, its interior gains, for the
/// sphere's surface over the plate has the Laplacian of the opposite sign (a divergence: both are one integral).
BudgetCase plane_on_sphere(Extent extent) {
  BudgetCase pair = sphere_on_plane(extent);
  pair.id = "plane-on-sphere";
  pair.title = "plane on sphere";
  pair.problem = "the same, the plate as master";
  pair.reference = "F = K pi h^2 (r - h/3)";
  pair.edge = plate_edge;
  pair.meshes = [](std::size_t level) { return BudgetMeshes{plate(level), sphere(level)}; };
  pair.equal_volume = [](std::size_t level) { return BudgetMeshes{plate(level), filled_sphere(level)}; };
  pair.placement = [](int i) { return seen_from_the_other(pressed(i)); };
  const auto force = static_cast<double>(closed_forms::sphere_on_plane_plane_master(kRadius, kDepth));
  pair.force_F = [force](int i) -> Eigen::Vector3d { return -force * pressed(i).R.row(2).transpose(); };

  const double border = border_of_sphere_on_plane(plate_edge(pair.levels - 1));
  pair.discretisation = no_more_than(0.25 * border, "no leading term; a quarter of what the border alone would cost");
  pair.one_pose = no_more_than(0.25 * border, "scatter that falls with the 2.5th power of the edge");
  // The volume of the cap falls by e^2 / 8 times its area 2 pi h.
  const double e = sphere_edge(pair.levels - 1), geometry = -e * e / (4 * kDepth * (1 - kDepth / 3));
  pair.geometry = second_order(geometry, -0.05 * geometry, extent, "leading term of the inscribed mesh");
  pair.geometry_equal_volume = no_more_than(e * e / 4, "what the cap loses it gains, but for terms of order e^2");
  return pair;
}

/// The direction from F to E: the bodies present another side to each other in every orientation.
Eigen::Vector3d direction(int orientation) {
  return fixed_rotation((orientation + 7) % kOrientations).col(2);
}

BudgetCase sphere_on_sphere(Extent extent) {
  const double distance = 2 * kRadius - 2 * kDepth;
  BudgetCase pair;
  pair.id = "sphere-on-sphere";
  pair.title = "sphere on sphere";
  pair.problem = "icospheres, r = 1 m, pressed by 0.1 m into each other";
  pair.reference = "integral of the penetration over the master, by quadrature";
  pair.levels = budget_levels(extent);
  pair.width = 2 * std::sqrt(kRadius * kRadius - distance * distance / 4);
  pair.in_words = spheres_in_words;
  pair.edge = sphere_edge;
  pair.meshes = [](std::size_t level) { return BudgetMeshes{sphere(level), sphere(level)}; };
  pair.equal_volume = [](std::size_t level) { return BudgetMeshes{filled_sphere(level), filled_sphere(level)}; };
  pair.placement = [distance](int i) { return Placement{fixed_rotation(i), distance * direction(i)}; };
  const auto force = static_cast<double>(closed_forms::sphere_on_sphere(kRadius, kRadius, distance));
  pair.force_F = [force](int i) -> Eigen::Vector3d { return force * direction(i); };

  // At the angle t from the axis the surfaces meet at an angle of cosine c = sqrt(1 - a^2 sin^2 t), a the distance;
  // cos t sin t dt / c and cos t sin t dt / c^3 have the integrals (1 - c) / a^2 and (1 / c - 1) / a^2. The Laplacian
  // is 1 / c + 1 / c^3; the border, where cos t = a / 2, has the slope a sin t (a cos t / c - 1).
  const double a = distance, cosine = a / 2, sine = std::sqrt(1 - cosine * cosine);
  const double c = std::sqrt(1 - a * a * sine * sine), e = sphere_edge(pair.levels - 1);
  const double interior = e * e * kPi / 24 * (1 / c - c) / (a * a) / force;
  const double border = e * e * kPi / 24 * sine * cosine * a * sine * (a * cosine / c - 1) / force;
  const double inscribed = e * e * kPi / 4 * (sine * sine / 2 + (1 - c) / (a * a)) / force;
  pair.discretisation = second_order(interior - border, 0.1 * border, extent, "leading terms, border and curvature");
  pair.one_pose = no_more_than(1.5 * (border - interior), kScatter);
  pair.geometry = second_order(-inscribed, 0.05 * inscribed, extent, "leading term of the inscribed meshes");
  pair.geometry_equal_volume =
      no_more_than(e * e / 4, "the depth's part is gone, that of the area, of order e^2, is left");
  return pair;
}

BudgetCase ball_in_socket(Extent extent) {
  BudgetCase pair;
  pair.id = "ball-in-socket";
  pair.title = "ball in socket";
  pair.problem = "icosphere, r = 1 m, displaced by 0.02 m in a hollow of R = 1.01 m made of meridians and parallels";
  pair.reference = "integral of the penetration over the ball, by quadrature";
  pair.levels = budget_levels(extent);
  const auto t = static_cast<double>(closed_forms::ball_contact_angle(kRadius, kHollow, kDisplacement));
  pair.width = 2 * kRadius * t;
  pair.in_words = [](std::size_t level) {
    return fmt::format("icosphere {}, socket {} x {}", 20 << (2 * refinements(level)), 4 * bands(level), bands(level));
  };
  pair.edge = sphere_edge;
  pair.meshes = [](std::size_t level) { return BudgetMeshes{sphere(level), hollow(level)}; };
  pair.equal_volume = [](std::size_t level) { return BudgetMeshes{filled_sphere(level), filled_hollow(level)}; };
  pair.placement = [](int i) { return Placement{fixed_rotation(i), {0, 0, -kDisplacement}}; };
  const auto force = static_cast<double>(closed_forms::sphere_in_socket_sphere_master(kRadius, kHollow, kDisplacement));
  pair.force_F = [force](int) { return Eigen::Vector3d(0, 0, force); };

  // The hollow's rectangles of sides b along a meridian and b sin s, cut in two, lie b^2 (1 + sin^2 s) / 12 inside on
  // the mean: over the contact's projected area, that adds b^2 / 12 pi (sin^2 t + sin^4 t / 2). Over the whole hollow
  // the mean is 5 b^2 / 36, which is what equal volume takes off again: too much near the pole, where the rectangles
  // are narrow.
  const double e = sphere_edge(pair.levels - 1), b = kHollow * kPi / 2 / bands(pair.levels - 1);
  const double square = std::sin(t) * std::sin(t), d = kDisplacement;
  const double ball = kPi * square * e * e / 8 / force;
  const double socket = kPi * b * b / 12 * (square + square * square / 2) / kHollow / force;
  const double evened = kPi * b * b * 5 / 36 * square / kHollow / force;
  pair.geometry = second_order(socket - ball, 0.05 * (socket + ball), extent, "leading terms, hollow and ball");
  pair.geometry_equal_volume =
      second_order(socket - evened, 0.05 * evened, extent, "the hollow's mesh is finer near its pole than on the mean");
  const double slope = d * std::sin(t) * (1 - d * std::cos(t) / std::sqrt(kHollow * kHollow - d * d * square));
  const double curvature = kPi * square * e * e / 24 / kHollow / force;
  const double border = kPi / 24 * e * e * std::sin(t) * std::cos(t) * slope / force;
  pair.discretisation =
      second_order(-curvature - border, 0.05 * curvature, extent, "leading terms, curvature and border");
  pair.one_pose = no_more_than(1.5 * (curvature + border), kScatter);
  return pair;
}

}  // namespace

std::vector<BudgetCase> budget_of_spheres(Extent extent) {
  return {sphere_on_plane(extent), plane_on_sphere(extent), sphere_on_sphere(extent), ball_in_socket(extent)};
}

}  // namespace pcm::compare
