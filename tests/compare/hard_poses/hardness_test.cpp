// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/hard_poses/hardness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/hard_poses/hard_state.h"
#include "compare/hard_poses/least_margin.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "tests/compare/least_margins.h"

namespace pcm::compare {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(LeastMargin, IsThatOfAllDecisionsThoughMostAreOnlyLookedAtInDoubles) {
  const TriangleMesh cube = generate::box({1, 1, 1}), wedge = generate::wedge(45, 1, 1, 1),
                     sphere = generate::icosphere(0.5, 1);
  const FeaturePair cubes(cube, cube), wedges(wedge, cube), spheres(sphere, cube);
  for (const FeaturePair* pair : {&cubes, &wedges, &spheres})
    for (const Stratum stratum :
         {Stratum::generic, Stratum::degenerate, Stratum::near_degenerate, Stratum::adversarial})
      for (std::uint64_t i = 0; i < 20; ++i) {
        const Pose pose = draw_pose(stratum, *pair, PoseRandom(5, static_cast<std::uint64_t>(stratum), 0, i)).pose;
        EXPECT_EQ(least_margin(*pair, pose), least_margins(*pair, pose).front()) << name(stratum) << " " << i;
      }
}

TEST(LeastMargin, OfSurfacesSmallerThanDoublesHaveProductsForIsTheSame) {
  TriangleMesh tiny = generate::box({1, 1, 1});
  for (Eigen::Vector3d& x : tiny.vertices) x *= 0x1p-340;
  const FeaturePair pair(tiny, tiny);
  const Pose pose{Eigen::Matrix3d::Identity(), {0x1.8p-341, 0x1.1p-341, 0x1.3p-341}};
  EXPECT_EQ(least_margin(pair, pose), least_margins(pair, pose).front());
}

TEST(LeastMargin, OfBodiesWhoseDecisionsAreAllTiesIsInfinite) {
  // A flat surface on itself: every four vertices lie in one plane.
  TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.faces = {{0, 1, 2}};
  EXPECT_EQ(least_margin(FeaturePair(flat, flat), Pose{}), kInfinity);
}

/// Two cubes of edge 1, F above E by `height` and beside it.
class HardnessOfCubes : public testing::Test {
 protected:
  double measure(Goal goal, double height, const ContactLaw& law = {}) {
    const HeldPairing::State state{
        {Eigen::Matrix3d::Identity(), {0.3125, 0.4375, height}}, {}, law, Scheme::barycentric, {}};
    return hardness(goal, *held_, 2, state, workspace_);
  }

  const TriangleMesh cube_ = generate::box({1, 1, 1});
  const std::shared_ptr<const HeldPairing> held_ = held_in_all_modes(cube_, cube_, {}, Scheme::barycentric);
  fast::Workspace workspace_;
};

TEST_F(HardnessOfCubes, ApartThereIsNothingHardButMargins) {
  for (const Goal goal : {Goal::exact_decisions, Goal::error_over_bound, Goal::bound_over_error})
    EXPECT_EQ(measure(goal, 3), 0) << name(goal);
  EXPECT_GT(measure(Goal::margins, 3), 1);
}

TEST_F(HardnessOfCubes, RestingOnEachOtherManyDecisionsAreExact) {
  EXPECT_GT(measure(Goal::exact_decisions, 1), 20);
  EXPECT_GT(measure(Goal::work, 1), measure(Goal::work, 3));
}

TEST_F(HardnessOfCubes, SunkAnErrorIsAPartOfItsBoundAndTheBoundSomeErrors) {
  const double part = measure(Goal::error_over_bound, 0.9375), wide = measure(Goal::bound_over_error, 0.9375);
  EXPECT_GT(part, 0);
  EXPECT_LT(part, 1);
  EXPECT_GT(wide, 1);
  EXPECT_LT(wide, 1e4);
}

TEST_F(HardnessOfCubes, LawsHaveAPartInErrorsAndBoundsOnly) {
  ContactLaw law;
  law.stiffness = 0x1.123456789abcdp20;
  for (const Goal goal : kGoals) {
    if (depends_on_law(goal)) continue;
    EXPECT_EQ(measure(goal, 0.9375, law), measure(goal, 0.9375)) << name(goal);
  }
  for (const Goal goal : {Goal::error_over_bound, Goal::bound_over_error})
    EXPECT_NE(measure(goal, 0.9375, law), measure(goal, 0.9375)) << name(goal);
}

}  // namespace
}  // namespace pcm::compare
