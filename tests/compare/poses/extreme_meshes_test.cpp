// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/extreme_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/poses/strata.h"
#include "fast/base/geometry.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "pcm/check.h"

namespace pcm::compare {
namespace {

double extent(const TriangleMesh& mesh, int axis) {
  double low = mesh.vertices.front()[axis], high = low;
  for (const Eigen::Vector3d& x : mesh.vertices) {
    low = std::min(low, x[axis]);
    high = std::max(high, x[axis]);
  }
  return high - low;
}

TEST(ExtremeMeshes, AreFitForContactAndNamedApart) {
  const TriangleMesh cube = generate::box({1, 1, 1}), ball = generate::icosphere(0.5, 1);
  std::set<std::string> names;
  for (std::size_t k = 0; k < kExtremes; ++k) {
    const auto [E, F] = extreme_meshes(cube, ball, k);
    EXPECT_TRUE(check(E).fit()) << E.name;
    EXPECT_TRUE(check(F).fit()) << F.name;
    EXPECT_EQ(E.faces, cube.faces);
    names.insert(E.name + ", " + F.name);
  }
  EXPECT_EQ(names.size(), kExtremes);
}

TEST(ExtremeMeshes, CubeKeepsItsSidesToTheBitWhereverItIsMoved) {
  const TriangleMesh cube = generate::box({1, 1, 1});
  double farthest = 0, least_side = 1, greatest_side = 1, flattest = 1;
  for (std::size_t k = 0; k < kExtremes; ++k) {
    const TriangleMesh E = extreme_meshes(cube, cube, k)[0];
    std::array<double, 3> sides{};
    for (int axis = 0; axis < 3; ++axis) {
      const double side = sides[static_cast<std::size_t>(axis)] = extent(E, axis);
      int exponent = 0;
      EXPECT_EQ(std::frexp(side, &exponent), 0.5) << E.name;  // a power of two
      least_side = std::min(least_side, side);
      greatest_side = std::max(greatest_side, side);
    }
    const double size = std::max({sides[0], sides[1], sides[2]});
    flattest = std::min(flattest, std::min({sides[0], sides[1], sides[2]}) / size);
    farthest = std::max(farthest, std::abs(E.vertices.front().x()) / size);
  }
  EXPECT_EQ(least_side, 0x1p-240);
  EXPECT_EQ(greatest_side, 0x1p240);
  EXPECT_EQ(flattest, 0x1p-50);
  EXPECT_GE(farthest, 0x1p50);
}

TEST(ExtremeMeshes, ZerosBecomeDenormalsOfEitherSignAndMinusZero) {
  TriangleMesh flat = generate::rectangle(1, 1, 2, 2);  // z = 0 everywhere
  bool positive = false, negative = false, minus_zero = false;
  for (std::size_t k = 0; k < kExtremes; ++k) {
    const TriangleMesh mesh = extreme_meshes(flat, flat, k)[0];
    for (const Eigen::Vector3d& x : mesh.vertices) {
      if (x.z() != 0 && std::fpclassify(x.z()) != FP_SUBNORMAL) continue;
      positive = positive || x.z() > 0;
      negative = negative || x.z() < 0;
      minus_zero = minus_zero || (x.z() == 0 && std::signbit(x.z()));
    }
  }
  EXPECT_TRUE(positive && negative && minus_zero);
}

/// Those of so many poses of a cube against itself whose construction begins with these words.
std::vector<DrawnPose> poses_constructed(std::string_view words, std::uint64_t of, const TriangleMesh& cube) {
  const FeaturePair pair(cube, cube);
  std::vector<DrawnPose> poses;
  for (std::uint64_t i = 0; i < of; ++i) {
    DrawnPose drawn = draw_pose(Stratum::extreme, pair, PoseRandom(5, 6, 7, i));
    if (drawn.construction.starts_with(words)) poses.push_back(std::move(drawn));
  }
  return poses;
}

TEST(StratumExtreme, DriftedRotationsBringAVertexExactlyOntoAFeature) {
  const TriangleMesh cube = generate::box({1, 1, 1});
  int exact = 0;
  for (const DrawnPose& drawn : poses_constructed("drifted, vertex on vertex", 400, cube)) {
    if (!drawn.exact) continue;
    SCOPED_TRACE(exact++);
    EXPECT_NE(Eigen::Matrix3d(drawn.pose.A.transpose() * drawn.pose.A), Eigen::Matrix3d::Identity());
    bool meets = false;
    for (const Eigen::Vector3d& x : cube.vertices) {
      const Eigen::Vector3d x_Me = ordered_product(drawn.pose.A, x) + drawn.pose.r;
      for (const Eigen::Vector3d& y : cube.vertices) meets = meets || x_Me == y;
    }
    EXPECT_TRUE(meets);
  }
  EXPECT_GE(exact, 10);
}

TEST(StratumExtreme, DriftedRotationsAreOffByUpToWhatTheEngineTakes) {
  const std::vector<DrawnPose> drifted = poses_constructed("drifted", 400, generate::box({1, 1, 1}));
  double greatest = 0;
  for (const DrawnPose& drawn : drifted) {
    const double error = fast::orthogonality_error(drawn.pose.A);
    EXPECT_LE(error, 1e-9);
    greatest = std::max(greatest, error);
  }
  EXPECT_GE(drifted.size(), 60U);
  EXPECT_GE(greatest, 9e-10);
}

TEST(StratumExtreme, DriftedFacesLieExactlyInOnePlaneAllTheSame) {
  const TriangleMesh cube = generate::box({1, 1, 1});
  const std::vector<DrawnPose> coplanar = poses_constructed("drifted, coplanar faces", 600, cube);
  for (const DrawnPose& drawn : coplanar) {
    int four_in_a_plane = 0;
    for (int axis = 0; axis < 3; ++axis)
      for (const double height : {-0.5, 0.5})
        four_in_a_plane += std::count_if(cube.vertices.begin(), cube.vertices.end(), [&](const Eigen::Vector3d& x) {
                             return (ordered_product(drawn.pose.A, x) + drawn.pose.r)[axis] == height;
                           }) == 4;
    EXPECT_GE(four_in_a_plane, 1);
  }
  EXPECT_GE(coplanar.size(), 10U);
}

}  // namespace
}  // namespace pcm::compare
