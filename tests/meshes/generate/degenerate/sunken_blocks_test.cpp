// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/generate/degenerate/sunken_blocks.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "pcm/check.h"

namespace pcm::sunken_blocks_test {
namespace {

bool is_on_grid(double x) {
  return x == std::ldexp(std::nearbyint(std::ldexp(x, 8)), -8);
}

/// The lines along x or y, each with the depths of the floors whose edges lie on it.
std::set<std::pair<double, std::set<double>>> lines_along(int axis, const TriangleMesh& mesh) {
  std::set<std::pair<double, std::set<double>>> lines;
  for (const Eigen::Vector3d& x : mesh.vertices) {
    std::set<double> depths;
    for (const Eigen::Vector3d& other : mesh.vertices)
      if (other[1 - axis] == x[1 - axis] && other.z() < 0 && other.z() > -2) depths.insert(other.z());
    lines.emplace(x[1 - axis], depths);
  }
  return lines;
}

TEST(SunkenBlocks, AreFitDyadicAndTheSameForANumber) {
  std::set<std::vector<double>> seen;
  for (std::uint64_t number = 0; number < 48; ++number) {
    SCOPED_TRACE(number);
    const auto pair = degenerate::sunken_blocks(number), again = degenerate::sunken_blocks(number);
    std::vector<double> all;
    std::size_t faces = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(pair[k].vertices, again[k].vertices);
      EXPECT_NO_THROW(require_fit(pair[k]));
      EXPECT_TRUE(check(pair[k]).closed());
      faces += pair[k].faces.size();
      for (const Eigen::Vector3d& x : pair[k].vertices)
        for (int j = 0; j < 3; ++j) {
          EXPECT_TRUE(is_on_grid(x[j])) << x[j];
          all.push_back(x[j]);
        }
    }
    EXPECT_EQ(faces, 72U);
    EXPECT_TRUE(seen.insert(all).second);
  }
}

TEST(SunkenBlocks, HaveEdgesInLineAtDifferentDepths) {
  int with_such_a_line = 0;
  for (std::uint64_t number = 0; number < 48; ++number) {
    bool has_one = false;
    for (const int axis : {0, 1})
      for (const auto& [place, depths] : lines_along(axis, degenerate::sunken_blocks(number)[1]))
        has_one = has_one || depths.size() > 1;
    with_such_a_line += has_one;
  }
  EXPECT_GE(with_such_a_line, 24);
}

constexpr std::size_t kCorners = 8;
using Blocks = std::vector<std::vector<Eigen::Vector3d>>;

/// The corners of all but the first, of both bodies.
Blocks smaller_blocks(std::uint64_t number) {
  Blocks blocks;
  for (const TriangleMesh& mesh : degenerate::sunken_blocks(number))
    for (std::size_t first = kCorners; first < mesh.vertices.size(); first += kCorners)
      blocks.emplace_back(mesh.vertices.begin() + static_cast<std::ptrdiff_t>(first),
                          mesh.vertices.begin() + static_cast<std::ptrdiff_t>(first + kCorners));
  return blocks;
}

TEST(SunkenBlocks, SmallerOnesAreFourInOneOfTheBodiesOrTheOtherAndApart) {
  std::size_t in_plates = 0;
  for (std::uint64_t number = 0; number < 48; ++number) {
    SCOPED_TRACE(number);
    in_plates += degenerate::sunken_blocks(number)[0].vertices.size() / kCorners - 1;
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const std::vector<Eigen::Vector3d>& block : smaller_blocks(number)) {
      Eigen::AlignedBox3d box;
      for (const Eigen::Vector3d& x : block) box.extend(x);
      for (const Eigen::AlignedBox3d& other : boxes) EXPECT_FALSE(box.intersects(other));
      boxes.push_back(box);
    }
    EXPECT_EQ(boxes.size(), 4U);
  }
  EXPECT_GE(in_plates, 48U);
  EXPECT_LE(in_plates, 96U);
}

TEST(SunkenBlocks, WallsLean) {
  for (std::uint64_t number = 0; number < 48; ++number)
    for (const std::vector<Eigen::Vector3d>& block : smaller_blocks(number))
      for (std::size_t a = 0; a < block.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
          if (block[a].z() == block[b].z()) continue;
          EXPECT_NE(block[a].x(), block[b].x()) << number;
          EXPECT_NE(block[a].y(), block[b].y()) << number;
        }
}

TEST(LeaningBlock, IsWiderAtItsFarEndByTheFactorAndAlongYByLess) {
  const TriangleMesh mesh = degenerate::leaning_block({0, 0}, {2, 4}, -1, 3, 2);
  Eigen::Vector3d low = mesh.vertices[0], high = low;
  for (const Eigen::Vector3d& x : mesh.vertices) {
    low = low.cwiseMin(x), high = high.cwiseMax(x);
    if (x.z() == -1) {
      EXPECT_TRUE((x.x() == 0 || x.x() == 2) && (x.y() == 0 || x.y() == 4)) << x.transpose();
    }
  }
  EXPECT_EQ(low, Eigen::Vector3d(-1, -1.5, -1));
  EXPECT_EQ(high, Eigen::Vector3d(3, 5.5, 3));
}

}  // namespace
}  // namespace pcm::sunken_blocks_test
