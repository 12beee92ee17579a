// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/simd/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcm::fast {

namespace {

/// In a tree's coordinates, beyond all that it holds.
constexpr double kFarAway = 1024;
/// Lengths that are greater might overflow in single precision, or their products: then nothing is told apart.
constexpr double kGreatestOfPose = 0x1p100, kGreatestOfRay = 0x1p60;
constexpr float kUnknown = std::numeric_limits<float>::infinity();

}  // namespace

WidePose::WidePose(const WideTree& E, const WideTree& F, const Placement& placement, double margin) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      rotation[i][j] = static_cast<float>(placement.A(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      rotation_absolute[i][j] = std::abs(rotation[i][j]);
    }
  }
  const Eigen::Vector3d shift_Me = placement.A * F.origin() + placement.r_Me - E.origin();
  for (std::size_t k = 0; k < 3; ++k) {
    shift[k] = static_cast<float>(shift_Me[static_cast<Eigen::Index>(k)] / E.unit());
  }
  const double exact_scale = F.unit() / E.unit();
  scale = static_cast<float>(exact_scale);
  const double radii = E.radius() + exact_scale * F.radius();
  constexpr double kV = 0x1p-24;
  constexpr double kBoxRoundings = 64, kPlaneRoundings = 128, kEdgeRoundings = 32;  // WidePose, in units of v G
  constexpr double kUp = 1 + 0x1p-20;  // pays for rounding to single precision
  const double in_double_E = 2 * placement.position_error_E / E.unit(),
               in_double_F = 2 * placement.position_error_F / E.unit();
  const double in_units = margin / E.unit();
  box_error_E = static_cast<float>(kUp * (kBoxRoundings * kV * radii + in_double_E + in_units));
  box_error_F = static_cast<float>(kUp * (kBoxRoundings * kV * radii + in_double_F + in_units));
  const double tilt = 2 * in_double_E / (WideTree::kLeastHeight * exact_scale) * 2 * radii;
  plane_error = static_cast<float>(kUp * (kPlaneRoundings * kV * radii + 2 * in_double_E + tilt + in_units));
  edge_error = exact_scale < 0x1p30
                   ? static_cast<float>(kUp * (kEdgeRoundings * kV * radii + 2 * in_double_E + 2 * in_units))
                   : kUnknown;
  if (radii < kGreatestOfPose) return;
  scale = 1;
  shift = {};
  box_error_E = box_error_F = plane_error = edge_error = kUnknown;
}

WideRay::WideRay(const WideTree& tree, const Eigen::Vector3d& ray_origin, const Eigen::Vector3d& ray_direction,
                 double distance) {
  const Eigen::Vector3d from_tree = (ray_origin - tree.origin()) / tree.unit();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    origin[k] = static_cast<float>(from_tree[axis]);
    direction[k] = static_cast<float>(ray_direction[axis]);
    inverse[k] = 1 / std::copysign(std::max(std::abs(direction[k]), 0x1p-60F), direction[k]);
  }
  box_error = static_cast<float>((1 + 0x1p-20) *
                                 (64 * 0x1p-24 * (tree.radius() + from_tree.lpNorm<1>()) + 2 * distance / tree.unit()));
  if (from_tree.lpNorm<1>() < kGreatestOfRay) return;
  origin = {};
  box_error = kUnknown;
}

WidePrism::WidePrism(const WideTree& tree, const TreePrism& prism, double deepest_depth) {
  constexpr double kUp = 1 + 0x1p-20;
  const auto error = [&](double x) {
    return kUp * (16 * 0x1p-24 * (tree.radius() + std::abs(x)) + prism.box_error() / tree.unit());
  };
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector3d& direction = k < 3 ? prism.inward()[k] : prism.down();
    const double from_tree = ((k < 3 ? prism.offset()[k] : prism.top()) - direction.dot(tree.origin())) / tree.unit();
    for (std::size_t i = 0; i < 3; ++i) {
      axis[k][i] = static_cast<float>(direction[static_cast<Eigen::Index>(i)]);
      axis_absolute[k][i] = std::abs(axis[k][i]);
    }
    offset[k] = static_cast<float>(from_tree - error(from_tree));
    if (k < 3) continue;
    const double end = from_tree + deepest_depth / tree.unit();
    deepest = std::abs(end) < kFarAway ? static_cast<float>(end + error(end)) : kUnknown;
  }
}

}  // namespace pcm::fast
