// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/predicates/orientation.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pcm::reference {
namespace {

TEST(PerturbationTerms, ComeByAscendingPowerOfEps) {
  // Powers 2^(3i - j): rank 1 carries 4 (x), 2 (y), 1 (z); rank 2 carries 32, 16, 8; and so on.
  const auto& terms = perturbation_terms<3>();
  ASSERT_EQ(terms.size(), 73u);  // partial matchings of four points and three coordinates
  EXPECT_EQ(terms[0], (PerturbationTerm<3>{-1, -1, -1, -1}));
  EXPECT_EQ(terms[1], (PerturbationTerm<3>{2, -1, -1, -1}));
  EXPECT_EQ(terms[2], (PerturbationTerm<3>{1, -1, -1, -1}));
  EXPECT_EQ(terms[3], (PerturbationTerm<3>{0, -1, -1, -1}));
  EXPECT_EQ(terms[4], (PerturbationTerm<3>{-1, 2, -1, -1}));
  EXPECT_EQ(terms[5], (PerturbationTerm<3>{1, 2, -1, -1}));
  EXPECT_EQ(terms[6], (PerturbationTerm<3>{0, 2, -1, -1}));
  EXPECT_EQ(terms[7], (PerturbationTerm<3>{-1, 1, -1, -1}));
  EXPECT_EQ(perturbation_terms<2>().size(), 13u);
}

/// E: three vertices in the plane z = 0; F: any number of further ones.
class OrientationOf : public ::testing::Test {
 protected:
  Surface surface(std::vector<Eigen::Vector3d> vertices) {
    return make_surface({std::move(vertices), {{0, 1, 2}}, "test"});
  }
};

TEST_F(OrientationOf, PointAboveFaceIsPositiveAndSwappingTwoPointsNegates) {
  const Surface E = surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Surface F = surface({{0.25, 0.25, 1}, {0.5, 0.25, -1}, {0, 1, 0}});
  const ExactPose pose(Problem::rounded, E, F, {});
  const Orientation orientation(pose);
  EXPECT_EQ(orientation.side({Side::F, 0}, Side::E, 0), 1);
  EXPECT_EQ(orientation.side({Side::F, 1}, Side::E, 0), -1);
  EXPECT_EQ(orientation.orient3d({Side::E, 1}, {Side::E, 0}, {Side::E, 2}, {Side::F, 0}), -1);
}

TEST_F(OrientationOf, CoplanarPointsAreDecidedByTheMostMovedCoordinate) {
  const Surface E = surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Surface F = surface({{0.25, 0.25, 0}, {2, 2, 0}, {0, 3, 0}});
  const ExactPose pose(Problem::rounded, E, F, {});
  const Orientation orientation(pose);
  EXPECT_EQ(orientation.exact_orientation({Side::E, 0}, {Side::E, 1}, {Side::E, 2}, {Side::F, 0}), 0);
  // E's first vertex rises most, so the plane rises by eps (1 - x - y): F's vertex at (1/4, 1/4) is left below it,
  // the one at (2, 2) above.
  EXPECT_EQ(orientation.side({Side::F, 0}, Side::E, 0), -1);
  EXPECT_EQ(orientation.side({Side::F, 1}, Side::E, 0), 1);
}

TEST_F(OrientationOf, TieRuleIsAntisymmetricForAllPermutationsOfIdenticalPoints) {
  const Surface E = surface({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  const Surface F = surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const ExactPose pose(Problem::exact, E, F, {});
  const Orientation orientation(pose);
  std::array<Vertex, 4> v{Vertex{Side::E, 0}, Vertex{Side::E, 1}, Vertex{Side::E, 2}, Vertex{Side::F, 0}};
  const int sign = orientation.orient3d(v[0], v[1], v[2], v[3]);
  EXPECT_NE(sign, 0);
  do {
    int inversions = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) inversions += v[j] < v[i];
    EXPECT_EQ(orientation.orient3d(v[0], v[1], v[2], v[3]), inversions % 2 == 0 ? sign : -sign);
  } while (std::next_permutation(v.begin(), v.end()));
}

TEST_F(OrientationOf, ShiftedFaceLeavesCoplanarPointsAbove) {
  const Surface E = surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Surface F = surface({{0.25, 0.25, 0}, {2, 2, 0}, {0, 3, 0}});
  const ExactPose pose(Problem::rounded, E, F, {});
  const Orientation orientation(pose, ShiftedFace{Side::E, 0});
  for (Index v = 0; v < 3; ++v) EXPECT_EQ(orientation.side({Side::F, v}, Side::E, 0), 1);
}

}  // namespace
}  // namespace pcm::reference
