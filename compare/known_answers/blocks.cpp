// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <cmath>

#include "compare/bodies/known_answer_bodies.h"
#include "compare/known_answers/problems.h"
#include "meshes/generate/boxes.h"

namespace pcm::compare {
namespace {

/// E the box, F the plate, on whose grid the box's sides lie; or beside it, in the clipped scheme only: the barycentric
/// one asks that the master's faces lie wholly under the patch or beside it.
KnownAnswer box_on_plane(Extent extent) {
  constexpr double kSide = 0.5, kDepth = 0.05, kStiffness = 100, kPlateWidth = 2;
  KnownAnswer problem;
  problem.id = "A1";
  problem.title = "box on plane";
  problem.problem =
      "A box of edge 0.5 m, in fixed orientations of its frame, stands 0.05 m deep in a plate of 2 m, upright; K = 100 "
      "N/m^3. The side walls contribute nothing.";
  problem.reference = "F = K A u = 1.25 N";
  for (const bool aligned : {true, false})
    for (const Mode mode : kModes)
      for (const Scheme scheme : kSchemes) {
        if (!aligned && scheme == Scheme::barycentric) continue;
        Series& series = problem.series.emplace_back();
        series.quantity = aligned ? "F_z, sides on grid lines" : "F_z, sides beside grid lines";
        series.mode = mode;
        series.scheme = scheme;
        series.reference = static_cast<long double>(kStiffness) * kSide * kSide * kDepth;
        series.scale = static_cast<double>(series.reference);
        series.orientations = extent == Extent::full ? 5 : 2;
        std::vector<std::vector<fast::Pairing>> pairings;
        for (const Index n : {1, 2, 4}) {
          const Index cells = aligned ? 8 * n : 7 * n;
          const fast::Surface plate(generate::plate(kPlateWidth, kPlateWidth, 1, cells, cells));
          const TriangleMesh box =
              generate::gridded_box({-kSide / 2, -kSide / 2, 0}, {kSide / 2, kSide / 2, kSide}, {n, n, n});
          std::vector<fast::Pairing>& level = pairings.emplace_back();
          for (int i = 0; i < series.orientations; ++i)
            level.emplace_back(fast::Surface(turned(box, fixed_rotation(i).transpose())), plate, stiffness(kStiffness),
                               mode, scheme);
          series.levels.push_back({fmt::format("box {0} x {0} x {0}, plate {1} x {1}", n, cells), kPlateWidth / cells,
                                   faces_of(level.front().surface_E(), plate), kSide / (kPlateWidth / cells),
                                   within(rounding(kPlateWidth / kDepth))});
        }
        series.reason = "exact but for rounding";
        const double aside = aligned ? 0 : 0.013;
        series.measure = [pairings, aside](std::size_t level, int orientation, fast::Workspace& workspace) {
          const Placement placement{fixed_rotation(orientation), {aside, aside / 2, -kDepth}};
          return load(pairings[level][static_cast<std::size_t>(orientation)], placement, workspace).force_F.z();
        };
      }
  return problem;
}

/// E the box, F the plate: the box covers one row of the plate's cells, and its front wall passes the barycentre of one
/// of its triangles, at 2/3 of a cell; the wall behind stays amid two barycentres.
KnownAnswer passing_edge(Extent) {
  constexpr double kDepth = 0.0625, kPlateWidth = 2, kStiffness = 100, kStep = 0x1p-40;
  KnownAnswer problem;
  problem.id = "A11";
  problem.title = "sharp slave edge passing a master element";
  problem.problem =
      "A box stands u = 1/16 m deep in a gridded plate and moves by 2^-39 m, so that one of its walls passes the "
      "barycentre of one of the plate's triangles, of area A; K = 100 N/m^3. Force after less force before.";
  problem.reference =
      "barycentric: K A u with the plate as master, half of it with both; clipped, or with the box as master: 0";
  for (const Mode mode : kModes)
    for (const Scheme scheme : kSchemes) {
      Series& series = problem.series.emplace_back();
      series.quantity = "jump of F_z, in K A u";
      series.mode = mode;
      series.scheme = scheme;
      const bool jumps = scheme == Scheme::barycentric && mode != Mode::E;
      series.reference = !jumps ? 0 : mode == Mode::F ? 1 : 0.5L;
      std::vector<fast::Pairing> pairings;
      std::vector<double> cells;
      for (const Index n : {16, 32, 64}) {
        const double cell = kPlateWidth / n;
        const TriangleMesh box =
            generate::box(Eigen::Vector3d(-3.5 * cell, 0.125 * cell, 0), Eigen::Vector3d(0, 0.875 * cell, 1));
        pairings.emplace_back(fast::Surface(box), fast::Surface(generate::plate(kPlateWidth, kPlateWidth, 1, n, n)),
                              stiffness(kStiffness), mode, scheme);
        cells.push_back(cell);
        // The wall sweeps 0.75 cell times 2^-39 of the plate's area, 1.5 2^-39 / cell of the element's.
        const double swept = mode == Mode::E ? 0 : 1.5 * 2 * kStep / cell;
        series.levels.push_back({fmt::format("plate {0} x {0}", n), cell,
                                 faces_of(pairings.back().surface_E(), pairings.back().surface_F()), 0,
                                 within(1.5 * swept + rounding(8 * kPlateWidth / kDepth))});
      }
      series.reason = "exact but for the area swept and rounding";
      series.measure = [pairings, cells](std::size_t level, int, fast::Workspace& workspace) {
        const double cell = cells[level], wall = cell * (2.0 / 3);
        const auto force = [&](double x) {
          return load(pairings[level], {Eigen::Matrix3d::Identity(), {x, 0, -kDepth}}, workspace).force_F.z();
        };
        return (force(wall + kStep) - force(wall - kStep)) / (kStiffness * cell * cell / 2 * kDepth);
      };
    }
  return problem;
}

}  // namespace

std::vector<KnownAnswer> blocks(Extent extent) {
  return {box_on_plane(extent), passing_edge(extent)};
}

}  // namespace pcm::compare
