// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compare/bodies/known_answer_bodies.h"
#include "compare/known_answers/problems.h"
#include "compare/random/random.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"

namespace pcm::compare {
namespace {

using Point = std::array<long double, 3>;

/// The part of a body below the plane z = 0.
struct Immersed {
  long double volume = 0;
  long double x = 0;  ///< of the centroid
  long double y = 0;
};

/// The triangle's part with z <= 0, at most a quadrangle.
std::vector<Point> below(const std::array<Point, 3>& triangle) {
  std::vector<Point> part;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &a = triangle[i], &b = triangle[(i + 1) % 3];
    if (a[2] <= 0) part.push_back(a);
    if ((a[2] < 0) == (b[2] < 0) || a[2] == 0 || b[2] == 0) continue;
    const long double t = a[2] / (a[2] - b[2]);
    part.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), 0});
  }
  return part;
}

/// By the divergence theorem: the fluxes of (0, 0, z), (0, 0, x z) and (0, 0, y z) through the surface below the plane;
/// through the plane itself they are 0. The means of z, x z and y z over a triangle are exact sums over its corners.
Immersed immersed_part(const TriangleMesh& mesh, const Placement& placement) {
  Immersed body;
  for (const Triangle& face : mesh.faces) {
    std::array<Point, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      for (Eigen::Index i = 0; i < 3; ++i) {
        corners[k][static_cast<std::size_t>(i)] = placement.p[i];
        for (Eigen::Index j = 0; j < 3; ++j)
          corners[k][static_cast<std::size_t>(i)] +=
              static_cast<long double>(placement.R(i, j)) * mesh.vertices[face[k]][j];
      }
    const std::vector<Point> part = below(corners);
    for (std::size_t k = 2; k < part.size(); ++k) {
      const Point &a = part[0], &b = part[k - 1], &c = part[k];
      const long double N_z = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      const auto mean_with_z = [&](std::size_t i) {
        return (a[i] * a[2] + b[i] * b[2] + c[i] * c[2] + (a[i] + b[i] + c[i]) * (a[2] + b[2] + c[2])) / 12;
      };
      body.volume += N_z / 2 * (a[2] + b[2] + c[2]) / 3;
      body.x += N_z / 2 * mean_with_z(0);
      body.y += N_z / 2 * mean_with_z(1);
    }
  }
  body.x /= body.volume;
  body.y /= body.volume;
  return body;
}

/// The body in fixed orientation i, sunk into z < 0 half as deep as its lowest overhang (a face that looks up) allows,
/// beside the middle of the plate.
Placement sunk(const TriangleMesh& mesh, int i) {
  Placement placement;
  placement.R = fixed_rotation(i);
  double lowest = std::numeric_limits<double>::infinity(), overhang = lowest;
  for (const Triangle& face : mesh.faces) {
    std::array<Eigen::Vector3d, 3> x;
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = ordered_product(placement.R, mesh.vertices[face[k]]);
      lowest = std::min(lowest, x[k].z());
    }
    if (ordered_cross(x[1] - x[0], x[2] - x[0]).z() > 0)
      for (const Eigen::Vector3d& corner : x) overhang = std::min(overhang, corner.z());
  }
  placement.p = {0.0625, -0.03125, -(lowest + overhang) / 2};
  return placement;
}

/// Greatest coordinate over depth: the condition of what is exact but for rounding. The torque's arm comes with it.
double condition(const TriangleMesh& mesh, double least_size, int orientations) {
  double worst = 0;
  for (int i = 0; i < orientations; ++i) {
    const Placement placement = sunk(mesh, i);
    double depth = 0, size = least_size;
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      depth = std::max(depth, -(ordered_product(placement.R, vertex) + placement.p).z());
      size = std::max(size, vertex.cwiseAbs().maxCoeff());
    }
    worst = std::max(worst, size / depth);
  }
  return worst;
}

enum class Quantity { force, arm, volume };

}  // namespace

std::vector<KnownAnswer> volumes(Extent extent) {
  constexpr double kPlateWidth = 4;
  KnownAnswer problem;
  problem.id = "A8";
  problem.title = "plane as master: the immersed volume";
  problem.problem =
      "A closed body, in fixed orientations, is sunk into a plate half as deep as its lowest overhang; the plate is "
      "master, K = 1 N/m^3. The arm is the distance of the force's line from the immersed centroid, in metres.";
  problem.reference =
      "F = K V along the plane's normal, through the centroid of the immersed volume V; V and centroid by "
      "the "
      "divergence theorem, in long double";
  const int orientations = extent == Extent::full ? 10 : 3;
  const std::vector<TriangleMesh> bodies{generate::box({1.5, 1.5, 1.5}), generate::icosphere(0.75, 3),
                                         generate::bubble(1), generate::torus(0.75, 0.25, 48, 24)};
  std::vector<fast::Surface> plates;
  std::vector<Index> cells{32, 64, 128};
  for (const Index n : cells) plates.emplace_back(generate::plate(kPlateWidth, kPlateWidth, 2, n, n));

  for (const TriangleMesh& mesh : bodies) {
    const fast::Surface body(mesh);
    const double exact = rounding(condition(mesh, kPlateWidth, orientations));
    for (const Scheme scheme : kSchemes)
      for (const Quantity quantity : {Quantity::force, Quantity::arm, Quantity::volume}) {
        // The volume depends on the polygons alone.
        if (quantity == Quantity::volume && scheme != Scheme::barycentric) continue;
        Series& series = problem.series.emplace_back();
        const char* name = quantity == Quantity::force ? "F_z / (K V)"
                           : quantity == Quantity::arm ? "arm"
                                                       : "volume / V";
        series.quantity = fmt::format("{}, {}", name, mesh.name);
        series.mode = Mode::F;
        series.scheme = scheme;
        series.reference = quantity == Quantity::arm ? 0 : 1;
        series.scale = 1;
        series.orientations = orientations;
        std::vector<fast::Pairing> pairings;
        for (std::size_t l = 0; l < cells.size(); ++l) {
          pairings.emplace_back(body, plates[l], stiffness(1), Mode::F, scheme);
          series.levels.push_back({fmt::format("{} faces, plate {} x {}", mesh.faces.size(), cells[l], cells[l]),
                                   kPlateWidth / cells[l],
                                   faces_of(body, plates[l]),
                                   0,
                                   {}});
        }
        const bool sampled = scheme == Scheme::barycentric && quantity != Quantity::volume;
        if (sampled) {
          // Second-order terms of border and interior cancel on the mean (the integral of the penetration's Laplacian
          // over all of the plate is 0); what is left depends on how the patch lies on the grid, and has no order.
          series.levels.back().deviation = within(quantity == Quantity::arm ? 0.002 : 0.01);
          series.reason = "measured: noise of the grid under the patch, no order";
        } else {
          for (Resolution& level : series.levels) level.deviation = within(exact);
          series.reason = "exact but for rounding";
        }
        series.measure = [pairings, quantity](std::size_t level, int orientation, fast::Workspace& workspace) {
          const TriangleMesh& E = pairings[level].surface_E().mesh();
          const Placement placement = sunk(E, orientation);
          const Immersed expected = immersed_part(E, placement);
          if (quantity == Quantity::volume) {
            Wanted wanted;
            wanted.force = wanted.elements = false;
            return static_cast<double>(fast::evaluate(pairings[level], placement.pose(), {}, wanted, workspace).volume /
                                       expected.volume);
          }
          const Load pressed = load(pairings[level], placement, workspace);
          if (quantity == Quantity::force) return static_cast<double>(pressed.force_F.z() / expected.volume);
          return std::hypot(static_cast<double>(-pressed.torque_F.y() / pressed.force_F.z() - expected.x),
                            static_cast<double>(pressed.torque_F.x() / pressed.force_F.z() - expected.y));
        };
      }
  }
  return {problem};
}

}  // namespace pcm::compare
