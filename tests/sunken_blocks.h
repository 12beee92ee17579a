// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <utility>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/degenerate/sunken_blocks.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::test {

/// degenerate::sunken_blocks, the body moved off the plate's middle.
struct SunkenBlocks {
  TriangleMesh plate, blocks;
  Pose pose;

  /// Odd seeds: turned, so that everything is off by roundings.
  explicit SunkenBlocks(unsigned seed) {
    std::array<TriangleMesh, 2> pair = degenerate::sunken_blocks(seed);
    plate = std::move(pair[0]);
    blocks = std::move(pair[1]);
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
  TriangleMesh plate, floor = degenerate::leaning_block({-6, -6}, {6, 6}, -1, 4, 1.25);
  Pose pose;

  /// Of a wider top no edge lies on the line in which it comes out of the floor.
  explicit BlockAndSlopingTop(double slope, double width = 1) {
    TriangleMesh own = degenerate::leaning_block({-4, -4}, {-4 + width, -3}, -1, -8, 0.8);
    for (Eigen::Vector3d& x : own.vertices)
      if (x.z() == -1) x.z() += slope * (x.y() - x.x());
    plate = degenerate::joined(generate::box({-16, -17, -5}, {16, 16, 0}), own);
    pose.r = {0.125, 0.25, 0};
  }
};

/// A block whose floor is in cells, and another one through it that begins to hide the floor just along an inner edge
/// of these: with a level floor of its own, or with one that slopes and comes out of the plate's top there.
struct BlockThroughCells {
  TriangleMesh plate = generate::box({-16, -17, -5}, {16, 16, 0}), blocks;
  Pose pose;

  explicit BlockThroughCells(double slope) {
    TriangleMesh other = slope == 0 ? degenerate::leaning_block({0, -0.75}, {1, 0.5}, -0.5, 6, 0.5)
                                    : degenerate::leaning_block({-1, -0.75}, {1, 0.5}, 0, 6, 0.5);
    for (Eigen::Vector3d& x : other.vertices)
      if (x.z() == 0) x.z() = slope * x.x();
    TriangleMesh cells = generate::gridded_box({-6, -6, -1}, {6, 6, 4}, {6, 6, 1});
    for (Eigen::Vector3d& x : cells.vertices)  // walls that lean outwards
      if (x.z() == 4) x.head<2>() *= 1.25;
    blocks = degenerate::joined(cells, other);
    pose.r = {0.125, 0.25, 0};
  }
};

}  // namespace pcm::test
