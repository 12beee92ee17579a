// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/predicates/orientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <vector>

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

/// In eps: coefficients by power.
using Polynomial = std::map<int, long>;

Polynomial plus(Polynomial a, const Polynomial& b, long times) {
  for (const auto& [power, coefficient] : b) a[power] += times * coefficient;
  return a;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [power_a, coefficient_a] : a)
    for (const auto& [power_b, coefficient_b] : b) result[power_a + power_b] += coefficient_a * coefficient_b;
  return result;
}

/// Of the first coefficient that is not 0.
int sign_of(const Polynomial& polynomial) {
  for (const auto& [power, coefficient] : polynomial)
    if (coefficient != 0) return coefficient > 0 ? 1 : -1;
  return 0;
}

/// Three vertices of E, then three of F, at small integers, moved as the tie rule has it.
class MovedPoints {
 public:
  explicit MovedPoints(std::mt19937_64& random) {
    const bool flat = random() % 2 == 0;
    for (Eigen::Vector3d& x : points_)
      for (int j = 0; j < 3; ++j) x[j] = flat && j == 2 ? 1 : static_cast<double>(random() % 3);
  }

  std::vector<Eigen::Vector3d> of(Side side) const {
    const auto first = points_.begin() + (side == Side::E ? 0 : 3);
    return {first, first + 3};
  }
  Polynomial determinant(const std::array<Vertex, 4>& v) const {
    const auto row = [&](int i, int j) { return plus(coordinate(v[i], j), coordinate(v[0], j), -1); };
    Polynomial sum;
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      const Polynomial minor = plus(product(row(2, k), row(3, l)), product(row(2, l), row(3, k)), -1);
      sum = plus(sum, product(row(1, j), minor), 1);
    }
    return sum;
  }

 private:
  Polynomial coordinate(Vertex v, int j) const {
    const int i = (v.side == Side::E ? 0 : 3) + v.index;  // from 0, as j
    return {{0, static_cast<long>(points_[i][j])}, {1 << (3 * (i + 1) - (j + 1)), 1}};
  }

  std::array<Eigen::Vector3d, 6> points_;
};

TEST_F(OrientationOf, SignsOfSumsAreThoseOfTheSumsOfAllPowersOfEps) {
  std::mt19937_64 random(21);
  SCOPED_TRACE("seed 21");
  int ties = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const MovedPoints points(random);
    const Surface E = surface(points.of(Side::E)), F = surface(points.of(Side::F));
    const ExactPose pose(Problem::exact, E, F, {});
    const Orientation orientation(pose);
    const Side side = trial % 2 == 0 ? Side::E : Side::F;
    std::vector<WeightedDeterminant> sum;
    Polynomial expected;
    for (Index i = 0; i < 3; ++i) {
      const std::array<Vertex, 4> v{Vertex{side, 0}, Vertex{side, 1}, Vertex{side, 2}, Vertex{other(side), i}};
      const long weight = static_cast<long>(random() % 5) - 2;
      sum.push_back({Exact(static_cast<double>(weight)), v});
      expected = plus(expected, points.determinant(v), weight);
      ASSERT_EQ(orientation.orient3d(v[0], v[1], v[2], v[3]), sign_of(points.determinant(v))) << trial;
    }
    ties += expected[0] == 0 ? 1 : 0;
    ASSERT_EQ(orientation.sign_of_sum(sum), sign_of(expected)) << trial;
  }
  EXPECT_GE(ties, 1000);
}

}  // namespace
}  // namespace pcm::reference
