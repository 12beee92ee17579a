// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::test {

/// With one end at this height, the other one, at `far`, wider by a factor, and along y by less: no edge that leans
/// runs along a floor's diagonal.
inline TriangleMesh block(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double height, double far,
                          double factor) {
  TriangleMesh mesh =
      generate::box({low.x(), low.y(), std::min(height, far)}, {high.x(), high.y(), std::max(height, far)});
  const Eigen::Vector2d middle = 0.5 * (low + high);
  for (Eigen::Vector3d& x : mesh.vertices)
    if (x.z() == far) x.head<2>() = middle + Eigen::Vector2d(factor, 0.9 * factor).cwiseProduct(x.head<2>() - middle);
  return mesh;
}

/// A block 1 m deep in a plate, and smaller ones in it, of the slave's and the plate's own, with floors at other
/// depths. All edges lie on the lines of a grid, so that the line of one goes on along others at other depths. No wall
/// is upright, and no two blocks touch.
struct SunkenBlocks {
  TriangleMesh plate = generate::box({-16, -17, -5}, {16, 16, 0});
  TriangleMesh blocks = block({-6, -6}, {6, 6}, -1, 4, 1.25);
  Pose pose;

  /// Odd seeds: turned, so that everything is off by roundings.
  explicit SunkenBlocks(unsigned seed) {
    std::mt19937 random(seed);
    const auto draw = [&random](int low, int high) {
      return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    std::vector<std::array<int, 4>> taken;
    for (int i = 0; i < 4; ++i) {
      const int x = draw(-5, 3), y = draw(-5, 3);
      const std::array<int, 4> place{x, y, x + draw(1, 2), y + draw(1, 2)};
      bool is_free = true;
      for (const auto& other : taken)
        is_free = is_free && (place[2] < other[0] || other[2] < place[0] || place[3] < other[1] || other[3] < place[1]);
      if (!is_free) continue;
      taken.push_back(place);
      const double depth = draw(1, 7) / 8.0;
      const Eigen::Vector2d low(place[0], place[1]), high(place[2], place[3]);
      if (draw(0, 2) == 0) {
        plate = degenerate::joined(std::move(plate), block(low, high, -depth, -8, 0.8));
      } else {
        blocks = degenerate::joined(std::move(blocks), block(low, high, -depth, 6, 0.5));
      }
    }
    pose.r = {0.125, 0.25, 0};
    if (seed % 2 == 0) return;
    pose.A = Eigen::AngleAxisd(0.37, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    pose.r = pose.A * pose.r;
    for (Eigen::Vector3d& x : plate.vertices) x = pose.A * x;
  }
};

/// The block alone with one of the plate's own, whose sloping top comes out of the block's floor along its diagonal,
/// higher to the one side of it or to the other.
struct BlockAndSlopingTop {
  TriangleMesh plate, floor = block({-6, -6}, {6, 6}, -1, 4, 1.25);
  Pose pose;

  explicit BlockAndSlopingTop(double slope) {
    TriangleMesh own = block({-4, -4}, {-3, -3}, -1, -8, 0.8);
    for (Eigen::Vector3d& x : own.vertices)
      if (x.z() == -1) x.z() += slope * (x.y() - x.x());
    plate = degenerate::joined(generate::box({-16, -17, -5}, {16, 16, 0}), own);
    pose.r = {0.125, 0.25, 0};
  }
};

}  // namespace pcm::test
