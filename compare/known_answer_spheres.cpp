// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "compare/closed_forms.h"
#include "compare/known_answer_bodies.h"
#include "compare/known_answer_problems.h"
#include "meshes/generate_boxes.h"
#include "meshes/generate_round.h"

namespace pcm::compare {
namespace {

constexpr double kRadius = 1;
constexpr double kSide = 1.5;  ///< of the plate: wider than the contact at the greatest depth by a quarter

/// Spheres and plates from coarse to fine; surfaces are shared, so copies are cheap.
struct Meshes {
  struct Level {
    Index refinements = 0;
    fast::Surface sphere;
    fast::Surface plate;
    double edge = 0;
  };
  std::vector<Level> levels;
  int orientations = kOrientations;
};

/// The plate's cells are about as wide as the sphere's edges.
Meshes meshes_for(Extent extent) {
  Meshes meshes;
  const Index finest = extent == Extent::full ? 7 : 5;
  if (extent == Extent::quick) meshes.orientations = 5;
  for (Index refinements = 2; refinements <= finest; ++refinements) {
    const TriangleMesh sphere = generate::icosphere(kRadius, refinements);
    const Index cells = Index{5} << (refinements - 2);
    meshes.levels.push_back({refinements, fast::Surface(sphere),
                             fast::Surface(generate::plate(kSide, kSide, kSide, cells, cells)), mean_edge(sphere)});
  }
  return meshes;
}

/// Mean deviation of inscribed meshes from the closed form, relative, divided by the edge length squared (radius 1).
/// A triangle of sides a, b, c lies (a^2 + b^2 + c^2) / 24 = e^2 / 8 inside the sphere on the mean and is smaller than
/// the patch it stands for by 5 e^2 / 24.
/// Sphere master: F is the integral of the depth z below the plane over the sphere's surface. z falls by e^2 / 8 cos t,
/// in all by pi (2h - h^2) e^2 / 8, the surface by its part.
/// Plane master: F is the volume, which falls by e^2 / 8 times the cap's area 2 pi h.
/// Barycentric, sphere master: where z changes its sign on a face, the integral of max(z, 0) is not its value at the
/// barycentre: a border of length 2 pi sin t with the slope sin t loses sin t / 2 times the second moment e^2 / 24 of a
/// face across it. Plane master: what the border loses the interior gains, on the mean.
double leading(Mode mode, Scheme scheme, double h) {
  const double sphere = -1 / (4 * h) - 1.0 / 12 - (scheme == Scheme::barycentric ? (2 * h - h * h) / (24 * h * h) : 0);
  const double plane = -1 / (4 * h * (1 - h / 3));
  if (mode == Mode::E) return sphere;
  if (mode == Mode::F) return plane;
  return (sphere + (1 - h / 3) * plane) / (2 - h / 3);
}

long double reference(Mode mode, double h) {
  const long double sphere = closed_forms::sphere_on_plane_sphere_master(kRadius, h);
  const long double plane = closed_forms::sphere_on_plane_plane_master(kRadius, h);
  return mode == Mode::E ? sphere : mode == Mode::F ? plane : (sphere + plane) / 2;
}

/// The force along the plane's normal, E the sphere, F the plate. The sphere's centre moves over a few cells with the
/// orientation.
Series pressed(const Meshes& meshes, double h, Mode mode, Scheme scheme) {
  Series series;
  series.quantity = fmt::format("F_z, h/r = {}", h);
  series.mode = mode;
  series.scheme = scheme;
  series.reference = reference(mode, h);
  series.scale = static_cast<double>(series.reference);
  series.orientations = meshes.orientations;
  const double width = 2 * std::sqrt(2 * kRadius * h - h * h);
  std::vector<fast::Pairing> pairings;
  for (const Meshes::Level& level : meshes.levels) {
    pairings.emplace_back(level.sphere, level.plate, stiffness(1), mode, scheme);
    series.levels.push_back({fmt::format("icosphere {}, plate {} x {}", 20 << (2 * level.refinements),
                                         5 << (level.refinements - 2), 5 << (level.refinements - 2)),
                             level.edge,
                             faces_of(level.sphere, level.plate),
                             width / level.edge,
                             {}});
  }
  series.measure = [pairings, h](std::size_t level, int orientation, fast::Workspace& workspace) {
    const double x = 0.618 * orientation, y = 0.755 * orientation;
    const Placement placement{fixed_rotation(orientation),
                              {0.1 * (x - std::floor(x)), 0.1 * (y - std::floor(y)), kRadius - h}};
    return load(pairings[level], placement, workspace).force_F.z();
  };
  return series;
}

/// What a series with meshes that converge to the closed form must show.
void expect_second_order(Series& series, double h) {
  const double e = series.levels.back().edge;
  series.levels.back().deviation = between(0.85, 1.2, leading(series.mode, series.scheme, h) * e * e);
  series.order = Band{1.9, 2.1};
}

KnownAnswer problem_of(const Meshes& meshes, const std::string& id, Mode mode, const std::string& title,
                       const std::string& formula) {
  KnownAnswer problem;
  problem.id = id;
  problem.title = title;
  problem.problem =
      "An inscribed icosphere of radius 1 m, in fixed orientations, is pressed by h into the top of a square plate; "
      "areal stiffness 1 N/m^3.";
  problem.reference = formula + "; CASES A2 to A4, by integration of the depth over the master's surface.";
  for (const double h : {0.01, 0.05, 0.2})
    for (const Scheme scheme : kSchemes) {
      Series& series = problem.series.emplace_back(pressed(meshes, h, mode, scheme));
      expect_second_order(series, h);
    }
  return problem;
}

}  // namespace

std::vector<KnownAnswer> spheres_on_planes(Extent extent) {
  const Meshes meshes = meshes_for(extent);
  return {problem_of(meshes, "A2", Mode::E, "sphere on plane, sphere master", "F = K pi r h^2"),
          problem_of(meshes, "A3", Mode::F, "sphere on plane, plane master", "F = K pi h^2 (r - h/3)"),
          problem_of(meshes, "A4", Mode::both, "sphere on plane, both masters", "F = K pi h^2 (r - h/6)")};
}

}  // namespace pcm::compare
