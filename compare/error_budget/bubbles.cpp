// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <oneapi/tbb/parallel_for.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "compare/bodies/closed_forms.h"
#include "compare/bodies/smooth_bubble.h"
#include "compare/error_budget/bodies.h"
#include "compare/random/random.h"
#include "meshes/generate/bubbles.h"

namespace pcm::compare {
namespace {

constexpr double kLength = 0.40;
constexpr double kDepth = 0.02;
constexpr double kPoleRadius = kLength * 3 / 14;  ///< of curvature, the smallest: (3/2)^2 / (2 (7/4)) of length / 3

Index finer(std::size_t level) {
  return Index{1} << level;
}

TriangleMesh bubble(std::size_t level) {
  return generate::bubble(kLength, finer(level));
}

TriangleMesh filled_bubble(std::size_t level) {
  const TriangleMesh mesh = bubble(level);
  return scaled_to_volume(mesh, enclosed_volume(mesh), smooth_bubble_volume(kLength));
}

/// Along a direction that changes with the orientation, pressed in by kDepth from where fine meshes begin to touch.
Placement pressed(const fast::Pairing& pairing, int orientation) {
  const Eigen::Vector3d direction = fixed_rotation((orientation + 7) % kOrientations).col(2);
  Placement placement{fixed_rotation(orientation), {}};
  fast::Workspace workspace;
  Wanted nothing;
  nothing.polygons = nothing.areas = nothing.force = nothing.elements = false;
  double touching = 0, apart = 1.25 * kLength;
  for (int halving = 0; halving < 24; ++halving) {
    const double middle = (touching + apart) / 2;
    placement.p = middle * direction;
    (fast::evaluate(pairing, placement.pose(), {}, nothing, workspace).touching ? touching : apart) = middle;
  }
  placement.p = (touching - kDepth) * direction;
  return placement;
}

/// Of a circle as large as the mean of the contacts.
double mean_width(const fast::Pairing& pairing, const std::vector<Placement>& placements) {
  fast::Workspace workspace;
  Wanted areas;
  areas.polygons = areas.force = areas.elements = false;
  double sum = 0;
  for (const Placement& placement : placements)
    sum += fast::evaluate(pairing, placement.pose(), {}, areas, workspace).E.area;
  return 2 * std::sqrt(sum / static_cast<double>(placements.size()) / static_cast<double>(closed_forms::kPi));
}

/// What such meshes take from the force, relative to it and along it: mean over the orientations of this extent.
double part_lost(const std::vector<Placement>& placements, const BubbleMesh& mesh,
                 const std::function<Eigen::Vector3d(int)>& force_F, Extent extent) {
  const int orientations = budget_orientations(extent);
  std::vector<double> parts(static_cast<std::size_t>(orientations));
  oneapi::tbb::parallel_for(0, orientations, [&](int i) {
    const Eigen::Vector3d force = force_F(i);
    parts[i] = ordered_dot(force_lost_to_meshes(kLength, placements[i], mesh), force) / ordered_dot(force, force);
  });
  return std::accumulate(parts.begin(), parts.end(), 0.0) / orientations;
}

BudgetCase bubble_on_bubble(Extent extent) {
  BudgetCase pair;
  pair.id = "bubble-on-bubble";
  pair.title = "bubble on bubble";
  pair.problem =
      "the paper's bubbles, 0.40 m long (950 faces at the coarsest level), pressed by 0.02 m into each other from many "
      "sides";
  pair.reference =
      "integral of the penetration over the smooth bubble, by quadrature over 1500 x 3000 points (to 1e-5)";
  pair.levels = budget_levels(extent);
  pair.in_words = [](std::size_t level) {
    return fmt::format("bubbles {}", 50 * finer(level) * (20 * finer(level) - 1));
  };
  pair.edge = [](std::size_t level) { return mean_edge(bubble(level)); };
  pair.meshes = [](std::size_t level) { return BudgetMeshes{bubble(level), bubble(level)}; };
  pair.equal_volume = [](std::size_t level) { return BudgetMeshes{filled_bubble(level), filled_bubble(level)}; };
  const fast::Surface fine(bubble(2));
  const fast::Pairing pairing(fine, fine);
  std::vector<Placement> placements;
  for (int i = 0; i < kOrientations; ++i) placements.push_back(pressed(pairing, i));
  pair.width = mean_width(pairing, placements);
  pair.placement = [placements](int i) { return placements[i]; };
  pair.force_F = [placements](int i) { return smooth_bubble_force(kLength, placements[i]); };
  pair.discretisation = second_order(extent, "the border's share and that of curvature are of second order");
  pair.one_pose = second_order(extent, "the same, and scatter that falls faster");
  // Terms without a small depth below the line are neglected: as with spheres, a quarter of (edge / radius)^2.
  const double neglected = 0.25 * std::pow(pair.edge(pair.levels - 1) / kPoleRadius, 2);
  for (const bool filled : {false, true}) {
    const BubbleMesh mesh{finer(pair.levels - 1), filled};
    (filled ? pair.geometry_equal_volume : pair.geometry) =
        second_order(-part_lost(placements, mesh, pair.force_F, extent), neglected, extent,
                     "leading term of the meshes, by quadrature");
  }
  return pair;
}

}  // namespace

std::vector<BudgetCase> budget_of_bubbles(Extent extent) {
  return {bubble_on_bubble(extent)};
}

}  // namespace pcm::compare
