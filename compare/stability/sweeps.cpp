// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/stability/sweeps.h"

#include <fmt/core.h>

#include <cmath>

#include "meshes/generate/round.h"

namespace pcm::compare::stability {
namespace {

constexpr double kSize = 2;        ///< of either body, m
constexpr Index kLevel = 2;        ///< 320 faces, where nothing else is said
constexpr double kDepth = 0x1p-4;  ///< in sizes, where nothing else is said

/// Of the vertices of the sweep `offset`, m: what doubles as great as 2^45 are multiples of, which is what a coordinate
/// of 2^44 sizes is as great as.
constexpr double kGrid = 0x1p-8;

/// In sizes: directions off the axes and off each other, in eighths, so that vertices on the grid can be added to their
/// multiples by powers of two without rounding. No component is as great as 1.
const Eigen::Vector3d kOffset_E{0.875, -0.625, 0.375}, kOffset_F{-0.375, 0.75, 0.875};

void snap_to_grid(TriangleMesh& mesh) {
  for (Eigen::Vector3d& x : mesh.vertices) x = (x / kGrid).array().round().matrix() * kGrid;
}

/// Both centres, so many sizes times their directions.
void move_off_origin(SweptBodies& bodies, double sizes) {
  for (Eigen::Vector3d& x : bodies.E.vertices) x += kSize * sizes * kOffset_E;
  for (Eigen::Vector3d& x : bodies.F.vertices) x += kSize * sizes * kOffset_F;
}

void stretch(TriangleMesh& mesh, double factor) {
  for (Eigen::Vector3d& x : mesh.vertices) x.x() *= factor;
}

std::vector<int> steps(Sweep sweep, Extent extent) {
  const bool full = extent == Extent::full;
  const auto range = [](int first, int last, int by) {
    std::vector<int> all;
    for (int step = first; step <= last; step += by) all.push_back(step);
    return all;
  };
  switch (sweep) {
    case Sweep::offset:
      return full ? range(0, 44, 4) : range(0, 40, 20);
    case Sweep::scale:
      return full ? range(-240, 240, 80) : range(-240, 240, 240);
    case Sweep::aspect:
      return full ? range(0, 50, 5) : range(0, 40, 20);
    case Sweep::depth:
    case Sweep::vertex: {
      std::vector<int> all =
          full ? std::vector{-1, -5, -10, -15, -20, -25, -30, -35, -40, -45, -48, -50} : std::vector{-1, -20, -40};
      if (sweep == Sweep::vertex) all.erase(all.begin());  // a vertex half a size deep touches as a face does
      return all;
    }
    case Sweep::faces:
      return full ? range(0, 5, 1) : range(0, 2, 1);
  }
  return {};
}

}  // namespace

std::string_view name(Sweep sweep) {
  constexpr std::array<std::string_view, kSweeps.size()> kNames = {"offset", "scale",  "aspect",
                                                                   "depth",  "vertex", "faces"};
  return kNames[static_cast<std::size_t>(sweep)];
}

std::string_view title(Sweep sweep) {
  constexpr std::array<std::string_view, kSweeps.size()> kTitles = {
      "offset of both bodies from their frames' origins, in sizes",
      "scale of all lengths",
      "aspect ratio of both bodies and their faces",
      "depth of a face in a face, in sizes",
      "depth of a vertex in a face, in sizes",
      "faces of either body"};
  return kTitles[static_cast<std::size_t>(sweep)];
}

double SweepPoint::parameter() const {
  return sweep == Sweep::faces ? 20 * std::ldexp(1.0, 2 * step) : std::ldexp(1.0, step);
}

std::string SweepPoint::in_words() const {
  return sweep == Sweep::faces ? fmt::format("{:.0f}", parameter()) : fmt::format("2^{}", step);
}

std::vector<SweepPoint> sweep_points(Sweep sweep, Extent extent) {
  std::vector<SweepPoint> points;
  for (const int step : steps(sweep, extent)) points.push_back({sweep, step});
  return points;
}

SweptBodies bodies_at(const SweepPoint& point) {
  const Index level = point.sweep == Sweep::faces ? static_cast<Index>(point.step) : kLevel;
  SweptBodies bodies;
  bodies.E = bodies.F = generate::icosphere(1, level);
  bodies.depth = kDepth * kSize;
  if (point.sweep == Sweep::offset) {
    snap_to_grid(bodies.E);
    snap_to_grid(bodies.F);
    move_off_origin(bodies, point.parameter());
  } else {
    move_off_origin(bodies, 0.5);
  }
  switch (point.sweep) {
    case Sweep::offset:
      break;
    case Sweep::scale:
      bodies.scale = point.parameter();
      break;
    case Sweep::aspect:
      stretch(bodies.E, point.parameter());
      stretch(bodies.F, point.parameter());
      break;
    case Sweep::vertex:
      bodies.feature = Feature::vertex;
      [[fallthrough]];
    case Sweep::depth:
      bodies.depth = point.parameter() * kSize;
      break;
    case Sweep::faces:
      bodies.depth = 0x1p-6 * kSize;  // so that the finest meshes have some hundred faces in contact
      break;
  }
  return bodies;
}

TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Eigen::Vector3d& x : mesh.vertices) x *= factor;
  return mesh;
}

}  // namespace pcm::compare::stability
