// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/arrow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace pcm::simulate {
namespace {

constexpr int kCorners = 16;  // of a circle
constexpr double kHeadLength = 6, kHeadWidth = 2.2;

/// A cone without its tip, or with it where a radius is 0.
struct Cone {
  Eigen::Vector3d from, to;
  double radius_from = 0, radius_to = 0;
};

void add(const Cone& cone, std::vector<std::array<Eigen::Vector3d, 3>>& triangles) {
  const Eigen::Vector3d axis = (cone.to - cone.from).normalized();
  const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  const auto spoke = [&](int i) -> Eigen::Vector3d {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    return std::cos(angle) * u + std::sin(angle) * v;
  };
  for (int i = 0; i < kCorners; ++i) {
    const Eigen::Vector3d a = cone.from + cone.radius_from * spoke(i), b = cone.from + cone.radius_from * spoke(i + 1);
    const Eigen::Vector3d c = cone.to + cone.radius_to * spoke(i), d = cone.to + cone.radius_to * spoke(i + 1);
    triangles.push_back({a, b, d});
    triangles.push_back({a, d, c});
    triangles.push_back({cone.from, b, a});
    triangles.push_back({cone.to, c, d});
  }
}

}  // namespace

std::vector<std::array<Eigen::Vector3d, 3>> arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                  double width) {
  const double length = (to - from).norm();
  const double head = std::min(kHeadLength * width, 0.6 * length);
  const double radius = head / kHeadLength;
  const Eigen::Vector3d neck = to - head / length * (to - from);
  std::vector<std::array<Eigen::Vector3d, 3>> triangles;
  add({from, neck, radius, radius}, triangles);
  add({neck, to, kHeadWidth * radius, 0}, triangles);
  return triangles;
}

}  // namespace pcm::simulate
