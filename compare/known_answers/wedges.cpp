// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "compare/bodies/closed_forms.h"
#include "compare/bodies/known_answer_bodies.h"
#include "compare/known_answers/problems.h"
#include "meshes/generate/boxes.h"

namespace pcm::compare {
namespace {

constexpr double kStiffness = 3;
constexpr double kWidth = 1;
constexpr double kDepth = 0.5;     ///< half the wedge's height, so that a row of an even grid ends there
constexpr double kPlateWidth = 6;  ///< of the plate

/// Force on the wedge at the depth h, x along the inward horizontal of the face tilted by p.
closed_forms::WedgeForce wedge_force(Mode mode, long double degrees, long double h) {
  constexpr long double kScale = static_cast<long double>(kStiffness) * kWidth;
  const closed_forms::WedgeForce wedge = closed_forms::wedge_on_plane_wedge_master(degrees, h);
  const closed_forms::WedgeForce plane = closed_forms::wedge_on_plane_plane_master(degrees, h);
  if (mode == Mode::E) return {kScale * wedge.x, kScale * wedge.z};
  if (mode == Mode::F) return {kScale * plane.x, kScale * plane.z};
  return {kScale * (wedge.x + plane.x) / 2, kScale * (wedge.z + plane.z) / 2};
}

/// E the wedge, F the plate, level by level and orientation by orientation of the wedge's frame.
struct Meshes {
  std::vector<std::vector<fast::Pairing>> pairings;
  std::vector<Resolution> levels;
};

Meshes meshes_for(double degrees, Mode mode, Scheme scheme, int orientations) {
  Meshes meshes;
  for (const Index n : {2, 4, 8}) {
    const Index cells = 6 * n;
    const fast::Surface plate(generate::plate(kPlateWidth, kPlateWidth, 5, cells, cells));
    std::vector<fast::Pairing>& level = meshes.pairings.emplace_back();
    for (int i = 0; i < orientations; ++i) {
      const TriangleMesh wedge = turned(generate::wedge(degrees, 2 * kDepth, kWidth, n), fixed_rotation(i).transpose());
      level.emplace_back(fast::Surface(wedge), plate, stiffness(kStiffness), mode, scheme);
    }
    meshes.levels.push_back({fmt::format("wedge {0} x {0}, plate {1} x {1}", n, cells),
                             kPlateWidth / cells,
                             faces_of(level.front().surface_E(), plate),
                             0,
                             {}});
  }
  return meshes;
}

Load load_at(const Meshes& meshes, std::size_t level, int orientation, double x, double depth,
             fast::Workspace& workspace) {
  return load(meshes.pairings[level][static_cast<std::size_t>(orientation)],
              {fixed_rotation(orientation), {x, 0, -depth}}, workspace);
}

/// How far the plate's barycentres are from the integral, relative, at most: the penetration is linear but for a kink
/// at the ridge, which lies on a grid line, and one at either border, where the two barycentres of a cell of width a
/// miss between 0 and slope a^2 / 18. The slopes are tan p and cot p, the force is h^2 / 2 times their sum.
double missed_at_borders(double a) {
  return a * a / (9 * kDepth * kDepth);
}

KnownAnswer wedge_on_plane(Extent extent) {
  KnownAnswer problem;
  problem.id = "A9";
  problem.title = "wedge on a frictionless plane";
  problem.problem =
      "A wedge of two perpendicular faces, one tilted p from the plane, stands h = 0.5 m deep on its edge, 1 m wide, "
      "in "
      "fixed orientations of its frame; K = 3 N/m^3, no friction.";
  problem.reference =
      "wedge master: F_z = (K w h^2 / 2)(1 / sin p + 1 / cos p), F_x / F_z = tan(p - 45 deg) although mu = 0; plane "
      "master: F_z = (K w h^2 / 2)(tan p + cot p), F_x = 0; their mean with both";
  const int orientations = extent == Extent::full ? 5 : 2;
  for (const double degrees : {45.0, 40.0, 30.0, 15.0})
    for (const Mode mode : kModes)
      for (const Scheme scheme : kSchemes) {
        const Meshes meshes = meshes_for(degrees, mode, scheme, orientations);
        const closed_forms::WedgeForce expected = wedge_force(mode, degrees, kDepth);
        const bool sampled = scheme == Scheme::barycentric && mode != Mode::E;
        // What the plate's faces, as master's, bring to the vertical force.
        const auto of_plate = static_cast<double>(wedge_force(Mode::F, degrees, kDepth).z / expected.z);
        const double share_of_plate = !sampled ? 0 : mode == Mode::both ? 0.5 * of_plate : of_plate;
        for (const bool vertical : {true, false}) {
          Series& series = problem.series.emplace_back();
          series.quantity = fmt::format("{}, p = {} deg", vertical ? "F_z" : "F_x / F_z", degrees);
          series.mode = mode;
          series.scheme = scheme;
          series.reference = vertical ? expected.z : expected.x / expected.z;
          series.scale = vertical ? static_cast<double>(expected.z) : 1;
          series.orientations = orientations;
          series.levels = meshes.levels;
          for (Resolution& level : series.levels) {
            const double missed = share_of_plate * missed_at_borders(level.edge);
            const double roundings = rounding(kPlateWidth / kDepth);
            // The plate's force, which is what misses some, is vertical.
            const double of_ratio = std::abs(static_cast<double>(series.reference)) * missed / (1 - missed) + roundings;
            level.deviation = vertical ? Band{-missed - roundings, roundings} : Band{-of_ratio, of_ratio};
          }
          series.reason =
              sampled ? "0 to a^2 / (9 h^2) missed at the borders, cells of width a" : "exact but for rounding";
          series.measure = [meshes, vertical](std::size_t level, int orientation, fast::Workspace& workspace) {
            const Eigen::Vector3d force = load_at(meshes, level, orientation, 0, kDepth, workspace).force_F;
            return vertical ? force.z() : force.x() / force.z();
          };
        }
      }
  return problem;
}

/// Down to h, along x by s, up again: the work of the contact force on the wedge. Down
/// and up by Gauss' rule of two points, exact for forces that grow with the depth squared.
double work_over_loop(const Meshes& meshes, std::size_t level, int orientation, double s, fast::Workspace& workspace) {
  const auto work_down = [&](double x) {
    double sum = 0;
    for (const double node : {-1.0, 1.0}) {
      const double h = kDepth / 2 * (1 + node / std::sqrt(3.0));
      sum -= kDepth / 2 * load_at(meshes, level, orientation, x, h, workspace).force_F.z();
    }
    return sum;
  };
  return work_down(0) + s * load_at(meshes, level, orientation, s / 2, kDepth, workspace).force_F.x() - work_down(s);
}

KnownAnswer loop_of_the_wedge(Extent extent) {
  constexpr double kSlide = 0.5;  // whole cells at every level, so that all positions are alike to the plate
  KnownAnswer problem;
  problem.id = "A10";
  problem.title = "closed loop over the wedge";
  problem.problem =
      "The wedge of A9 is pressed down by h = 0.5 m, slid by 0.5 m along the plane and lifted again: work of the "
      "contact "
      "force on it, which a conservative force would not do.";
  problem.reference = "F_x s with F_x of A9: wedge master F_z tan(p - 45 deg) s, plane master 0, both half";
  const int orientations = extent == Extent::full ? 3 : 1;
  for (const double degrees : {45.0, 30.0, 15.0})
    for (const Mode mode : kModes)
      for (const Scheme scheme : kSchemes) {
        const Meshes meshes = meshes_for(degrees, mode, scheme, orientations);
        const closed_forms::WedgeForce expected = wedge_force(mode, degrees, kDepth);
        Series& series = problem.series.emplace_back();
        series.quantity = fmt::format("work, p = {} deg, in F_z s", degrees);
        series.mode = mode;
        series.scheme = scheme;
        series.scale = 1;
        series.reference = expected.x / expected.z;
        series.orientations = orientations;
        series.levels = meshes.levels;
        for (Resolution& level : series.levels) level.deviation = within(rounding(4 * kPlateWidth / kDepth));
        series.reason = "exact but for rounding";
        series.measure = [meshes, scale = static_cast<double>(expected.z) * kSlide](std::size_t level, int orientation,
                                                                                    fast::Workspace& workspace) {
          return work_over_loop(meshes, level, orientation, kSlide, workspace) / scale;
        };
      }
  return problem;
}

}  // namespace

std::vector<KnownAnswer> wedges(Extent extent) {
  return {wedge_on_plane(extent), loop_of_the_wedge(extent)};
}

}  // namespace pcm::compare
