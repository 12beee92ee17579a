// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The twin itself, on cases worked out by hand and on identities that hold for every pose.
#include "tests/reference/brute_force/brute_force.h"

#include <gtest/gtest.h>

#include "meshes/generate/boxes.h"
#include "tests/reference/brute_force/trials.h"
#include "tests/shifted_pose.h"

namespace pcm::brute_force {
namespace {

using reference::Problem;

Answer boxes(const Eigen::Vector3d& extents, const Pose& pose) {
  return answer(generate::box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 2, 2)),
                generate::box(Eigen::Vector3d(0, 0, 0), extents), pose, Problem::exact);
}

TEST(BruteForce, CornerOfCubeInCubeHasAUnitCubeOfIntersection) {
  // [1, 3]^3 against [0, 2]^3: three unit squares of each surface bound the cube [1, 2]^3.
  const Answer a = boxes({2, 2, 2}, shifted(1, 1, 1));
  EXPECT_TRUE(a.touching);
  EXPECT_EQ(a.polygons.size(), 1u);
  EXPECT_TRUE(a.polygons.front().closed);
  EXPECT_EQ(a.patches, 1);
  EXPECT_EQ(a.E.area, 3);
  EXPECT_EQ(a.F.area, 3);
  EXPECT_EQ(a.E.perturbed_area, 3);
  EXPECT_EQ(a.F.perturbed_area, 3);
  EXPECT_EQ(a.volume, 1);
  EXPECT_EQ(a.perturbed_volume, 1);
  EXPECT_EQ(a.E.vector_area, (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(a.F.vector_area, (std::array<double, 3>{-1, -1, -1}));
}

TEST(BruteForce, RestingBoxCountsInNeitherAreaAndInTheClosedBound) {
  // [0, 1]^2 x [2, 3] upon [0, 2]^3, off the rim by 1/2: the unit square between them has opposite normals.
  const Answer a = boxes({1, 1, 1}, shifted(0.5, 0.5, 2));
  for (const ActiveArea& active : {a.E, a.F}) {
    EXPECT_EQ(active.open, 0);
    EXPECT_EQ(active.closed, 1);
    EXPECT_EQ(active.area, 0);
  }
  EXPECT_EQ(a.volume, 0);
}

TEST(BruteForce, FlushFlanksCountInTheAreaOfEOnly) {
  // [0, 2]^2 x [1, 3]: E's top (4) and the upper halves of its flanks (4 x 2, covered by F's of the same normal) lie in
  // F; of F its bottom (4) and, covered, the lower halves of its flanks.
  const Answer a = boxes({2, 2, 2}, shifted(0, 0, 1));
  EXPECT_EQ(a.E.open, 4);
  EXPECT_EQ(a.E.closed, 12);
  EXPECT_EQ(a.E.area, 12);
  EXPECT_EQ(a.F.open, 4);
  EXPECT_EQ(a.F.closed, 12);
  EXPECT_EQ(a.F.area, 4);
  EXPECT_EQ(a.volume, 4);
}

TEST(BruteForce, IdenticalBoxesShareAllOfTheirSurface) {
  const Answer a = boxes({2, 2, 2}, shifted(0, 0, 0));
  EXPECT_EQ(a.E.open, 0);
  EXPECT_EQ(a.E.closed, 24);
  EXPECT_EQ(a.E.area, 24);
  EXPECT_EQ(a.F.area, 0);
  EXPECT_EQ(a.volume, 8);
}

TEST(BruteForce, BoxInsideAnotherIsNested) {
  const Answer a = boxes({1, 1, 1}, shifted(0.5, 0.5, 0.5));
  EXPECT_FALSE(a.touching);
  EXPECT_TRUE(a.nested);
  EXPECT_EQ(a.F.inner.size(), 12u);
  EXPECT_TRUE(a.E.inner.empty());
  EXPECT_EQ(a.F.area, 6);
  EXPECT_EQ(a.E.area, 0);
  EXPECT_EQ(a.volume, 1);
}

TEST(BruteForce, RodThroughACubeHasTwoPolygonsInOnePatch) {
  // Half by half by 4: four strips of 0.5 x 2 on the rod, two squares of 0.5 x 0.5 on the cube.
  const Answer a = boxes({0.5, 0.5, 4}, shifted(0.75, 0.75, -1));
  EXPECT_EQ(a.polygons.size(), 2u);
  EXPECT_EQ(a.patches, 1);
  EXPECT_EQ(a.E.area, 0.5);
  EXPECT_EQ(a.F.area, 4);
  EXPECT_EQ(a.volume, 0.5);
}

TEST(BruteForce, DeepBoxUnderAPlateHasElementsOfItsDepth) {
  // F = [0.25, 1.75]^2 x [1.5, 3.5]; master F: its bottom's two faces lie 0.5 below E's top.
  const Answer a = answer(generate::box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 2, 2)),
                          generate::box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1.5, 1.5, 2)),
                          shifted(0.25, 0.25, 1.5), Problem::exact, Mode::F);
  ASSERT_EQ(a.elements.size(), 2u);
  for (const Element& element : a.elements) {
    EXPECT_EQ(penetration(a.scene, element), 0.5);
    EXPECT_EQ(element_area(a.scene, element), 1.125);
  }
  const ForceAndTorque load = elastic_force(a, 8, Mode::F);
  EXPECT_EQ(load.force, (std::array<double, 3>{0, 0, -9}));  // 8 * 2.25 * 0.5, pressing E down
}

TEST(BruteForce, TieRuleIsAntisymmetricAndNeverUndecided) {
  const Vector x{1, 2, 3};
  const Vector y{1, 2, 4};
  const std::array<RankedPoint, 4> p{{{&x, 3}, {&x, 7}, {&y, 1}, {&x, 40}}};
  const int sign = orientation(p[0], p[1], p[2], p[3]);
  EXPECT_NE(sign, 0);
  EXPECT_EQ(orientation(p[1], p[0], p[2], p[3]), -sign);
  EXPECT_EQ(orientation(p[0], p[1], p[3], p[2]), -sign);
  EXPECT_EQ(orientation(p[1], p[2], p[3], p[0]), -sign);
}

TEST(BruteForce, RootsThatCancelAreZeroAndSquaresAreExact) {
  EXPECT_EQ(rounded(std::vector<Root>{{1, 2}, {Rational(-1, 2), 8}}), 0);
  EXPECT_EQ(rounded(std::vector<Root>{{3, Rational(4, 9)}, {1, 1}}), 3);
  EXPECT_EQ(rounded(std::vector<Root>{{1, 2}}), 1.4142135623730951);
}

class BruteForceIdentities : public testing::TestWithParam<Kind> {};

TEST_P(BruteForceIdentities, VectorAreasCancelAndFluxesGiveOneVolume) {
  int touching = 0;
  for (int number = 0; number < 60; ++number) {
    const Trial trial = draw_trial(GetParam(), 7, number);
    SCOPED_TRACE(trial.description);
    const Answer a = answer(trial.E, trial.F, trial.pose, Problem::rounded);
    touching += a.touching ? 1 : 0;
    if (!a.scene.E.closed || !a.scene.F.closed) continue;
    EXPECT_EQ(a.E.exact_vector_area + a.F.exact_vector_area, Vector{});
    EXPECT_EQ(a.fluxes[0], a.fluxes[1]);
    EXPECT_EQ(a.fluxes[1], a.fluxes[2]);
    const Rational unit = a.scene.unit;
    EXPECT_EQ(rounded(Rational(a.fluxes[0] * unit * unit * unit)), *a.volume);
    // Where nothing is coplanar, the sweep from the crossings gives the very areas of the prisms.
    for (const Side side : {Side::E, Side::F}) {
      const ActiveArea& active = a.active(side);
      for (const Share& share : active.shares) {
        EXPECT_GE(share.below, 0);
        EXPECT_LE(share.below + share.opposite, 1);
        if (share.equal != 0 || share.opposite != 0) continue;
        EXPECT_EQ(share.perturbed, share.below);
      }
    }
  }
  EXPECT_GE(touching, 10);
}

INSTANTIATE_TEST_SUITE_P(Poses, BruteForceIdentities,
                         testing::Values(Kind::generic, Kind::lattice, Kind::near_lattice, Kind::grids),
                         [](const testing::TestParamInfo<Kind>& test) { return name_of(test.param); });

}  // namespace
}  // namespace pcm::brute_force
