// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "compare/poses/orientation_margin.h"
#include "compare/poses/strata.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "tests/compare/least_margins.h"

namespace pcm::compare {
namespace {

using Eigen::Vector3d;

TEST(OrientationMargin, IsTheHeightOverTheUnitTriangle) {
  // Determinant h; its terms add up to h where the other coordinates are 0.
  EXPECT_EQ(orientation_margin({Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 0.25)}), 1);
  EXPECT_EQ(orientation_margin({Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0.5, 0.25, 0)}), 0);
}

TEST(OrientationMargin, SeesWhatRoundingLoses) {
  // (1, 1, 1) and a neighbour of it in the plane through 0, (1, 0, 0) and (1, 1, 1): off by one ulp in z.
  const double z = std::nextafter(1, 2);
  const double margin =
      orientation_margin({Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(1, 1, 1), Vector3d(0.5, 1, z)});
  EXPECT_GT(margin, 0x1p-54);
  EXPECT_LT(margin, 0x1p-52);
}

TEST(OrientationMargin, OfFourEqualPointsIsZero) {
  const Vector3d x(0.5, 0.25, 2);
  EXPECT_EQ(orientation_margin({x, x, x, x}), 0);
}

/// Margin number k (0: the least) of each of the poses, ascending.
std::vector<double> margins_of_poses(Stratum stratum, const FeaturePair& pair, std::uint64_t poses, std::size_t k) {
  std::vector<double> margins;
  for (std::uint64_t i = 0; i < poses; ++i) {
    const DrawnPose drawn = draw_pose(stratum, pair, PoseRandom(3, static_cast<std::uint64_t>(stratum), 1, i));
    margins.push_back(least_margins(pair, drawn.pose)[k]);
  }
  std::sort(margins.begin(), margins.end());
  return margins;
}

TEST(StratumAdversarial, ThreeDecisionsAreWithinRoundingsOfATie) {
  const TriangleMesh cube = generate::box({1, 1, 1}), wedge = generate::wedge(45, 1, 1, 1);
  const FeaturePair cubes(cube, cube), wedges(wedge, cube);
  for (const FeaturePair* pair : {&cubes, &wedges}) {
    EXPECT_LT(margins_of_poses(Stratum::adversarial, *pair, 60, 2)[30], 0x1p-51);
    EXPECT_GT(margins_of_poses(Stratum::generic, *pair, 60, 2)[30], 0x1p-30);
  }
}

TEST(StratumAdversarial, HardestPosesAreAThousandTimesHarderThanTheHardestGenericOnes) {
  const TriangleMesh cube = generate::box({1, 1, 1}), wedge = generate::wedge(45, 1, 1, 1);
  const FeaturePair pair(wedge, cube);
  constexpr std::size_t kHardest = 100;
  const std::vector<double> searched = margins_of_poses(Stratum::adversarial, pair, 2 * kHardest, 0);
  const std::vector<double> drawn = margins_of_poses(Stratum::generic, pair, 2 * kHardest, 0);
  // The easiest of those hundred, and the hardest of these.
  EXPECT_LT(searched[kHardest - 1], 1e-3 * drawn.front());
  RecordProperty("searched", std::to_string(std::log2(searched[kHardest - 1])));
  RecordProperty("drawn", std::to_string(std::log2(drawn.front())));
}

TEST(StratumAdversarial, MostPosesHaveThreeDecisionsToBringNear) {
  const TriangleMesh cube = generate::box({1, 1, 1});
  const FeaturePair pair(cube, cube);
  int near = 0;
  for (std::uint64_t i = 0; i < 100; ++i)
    near += draw_pose(Stratum::adversarial, pair, PoseRandom(3, 7, 1, i)).construction == "three decisions near a tie";
  EXPECT_GE(near, 95);
}

}  // namespace
}  // namespace pcm::compare
