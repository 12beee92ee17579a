// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict over one pose: right answers pass, answers altered on purpose are flagged.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "compare/verify/bounds/rounding_bounds.h"
#include "compare/verify/run/verify.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"
#include "tests/compare/small_pair.h"
#include "tests/compare/verify/routes/altering_seam.h"

namespace pcm::compare {
namespace {

/// Alters the engine's answer; false where it has nothing to alter, or where altering changes nothing.
using Alteration = std::function<bool(fast::Contact&)>;

/// Tries the alteration on generic poses until it has changed 100 answers; each must be flagged with the kind, and
/// each unaltered answer must pass.
void expect_always_flagged(Kind kind, const Alteration& alter, double least_relative_depth = 0) {
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, pair.law, Mode::both);
  fast::Workspace workspace;
  int altered = 0;
  for (std::uint64_t i = 0; altered < 100; ++i) {
    ASSERT_LT(i, 5000U) << "too few poses have something to alter";
    const DrawnPose drawn = draw_pose(Stratum::generic, held.features(), PoseRandom(11, 0, 0, i));
    const Question question = held.question(drawn.pose, drawn.velocity);
    const reference::Answer true_rounded =
        held.oracle().answer(reference::Problem::rounded, drawn.pose, drawn.velocity);
    if (true_rounded.max_penetration < least_relative_depth * held.features().size()) continue;
    fast::Contact subj = fast::evaluate(held.engine(), drawn.pose, drawn.velocity, Wanted{}, workspace);
    const std::vector<Disagreement> none = disagreements(question, subj, true_rounded);
    ASSERT_TRUE(none.empty()) << "pose " << i << ": " << name(none.front().kind) << ": " << none.front().text;
    if (!alter(subj)) continue;
    ++altered;
    const std::vector<Disagreement> found = disagreements(question, subj, true_rounded);
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Disagreement& d) { return d.kind == kind; }))
        << "pose " << i;
  }
}

TEST(Verdict, DroppedIntersectedFaceIsFlagged) {
  expect_always_flagged(Kind::intersected_faces, [](fast::Contact& subj) {
    if (subj.E.intersected.empty()) return false;
    subj.E.intersected.pop_back();
    return true;
  });
}

TEST(Verdict, DroppedInnerFaceIsFlagged) {
  expect_always_flagged(Kind::inner_faces, [](fast::Contact& subj) {
    if (subj.F.inner.empty()) return false;
    subj.F.inner.erase(subj.F.inner.begin());
    return true;
  });
}

TEST(Verdict, DroppedElementIsFlagged) {
  expect_always_flagged(Kind::elements, [](fast::Contact& subj) {
    if (subj.elements.empty()) return false;
    subj.elements.pop_back();
    --subj.element_count;
    return true;
  });
}

TEST(Verdict, ReversedPolygonIsFlagged) {
  expect_always_flagged(Kind::polygon_cycle, [](fast::Contact& subj) {
    if (subj.polygons.empty()) return false;
    const fast::Polygon& polygon = subj.polygons.front();
    // It still starts at its smallest crossing: only the circulation is wrong.
    std::reverse(subj.crossings.begin() + polygon.first + 1, subj.crossings.begin() + polygon.first + polygon.count);
    return polygon.count > 2;
  });
}

TEST(Verdict, DroppedPolygonIsFlagged) {
  expect_always_flagged(Kind::polygon_count, [](fast::Contact& subj) {
    if (subj.polygons.empty()) return false;
    subj.polygons.pop_back();
    return true;
  });
}

TEST(Verdict, SwappedCrossingIsFlagged) {
  expect_always_flagged(Kind::polygon_cycle, [](fast::Contact& subj) {
    if (subj.polygons.empty() || subj.polygons.front().count < 3) return false;
    const auto first = subj.crossings.begin() + subj.polygons.front().first;
    std::swap(first[1], first[2]);
    return true;
  });
}

TEST(Verdict, CrossingOfAnotherFaceIsFlagged) {
  expect_always_flagged(Kind::polygon_cycle, [](fast::Contact& subj) {
    if (subj.polygons.empty()) return false;
    subj.crossings[static_cast<std::size_t>(subj.polygons.front().first)].face ^= 1;
    return true;
  });
}

// Where the penetration is a small part of the size, 1e-9 is less than what rounding alone may do: the depths of the
// right answers on the rounded problem are uncertain by 1e-16 sizes or more. So these poses are a thousandth deep.
constexpr double kDeep = 1e-3;

TEST(Verdict, ForceOffByOneInABillionIsFlagged) {
  expect_always_flagged(
      Kind::force,
      [](fast::Contact& subj) {
        if (subj.force_Me.norm() == 0) return false;
        subj.force_Me *= 1 + 1e-9;
        return true;
      },
      kDeep);
}

TEST(Verdict, TorqueOffByABillionthOfItsTermsIsFlagged) {
  expect_always_flagged(
      Kind::torque,
      [](fast::Contact& subj) {
        // The elements' torques may cancel; what their sum can be wrong by is measured against their sizes.
        double sizes = 0;
        for (const fast::Element& e : subj.elements) sizes += e.position_Me.norm() * e.force_Me.norm();
        subj.torque_Me.x() += 1e-9 * sizes;
        return sizes > 0;
      },
      kDeep);
}

TEST(Verdict, AreaOffByOneInABillionIsFlagged) {
  expect_always_flagged(
      Kind::area,
      [](fast::Contact& subj) {
        subj.E.area *= 1 + 1e-9;
        return subj.E.area > 0;
      },
      kDeep);
}

/// Boxes stacked, flush and in one place, in all directions: the engine's areas are those that its tie rule gives, and
/// no other area that leaves coplanar faces out or counts them in will do.
TEST(Verdict, AreaThatCountsCoplanarFacesOtherwiseThanTheTieRuleIsFlagged) {
  const TriangleMesh E = generate::box({0, 0, 0}, {2, 2, 2}),
                     F = generate::gridded_box({0, 0, 0}, {2, 2, 2}, {2, 3, 1});
  const HeldPairing held(E, F, ContactLaw{}, Mode::E);
  fast::Workspace workspace;
  int altered = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double distance : {-2.0, -0.75, 0.0, 1.0, 2.0}) {
      Pose pose;
      pose.r[axis] = distance;
      const Question question = held.question(pose, Velocity{});
      const reference::Answer truth = held.oracle().answer(reference::Problem::rounded, pose);
      const fast::Contact subj = fast::evaluate(held.engine(), pose, Velocity{}, Wanted{}, workspace);
      EXPECT_TRUE(disagreements(question, subj, truth).empty()) << axis << ' ' << distance;
      const reference::AreaInterval& interval = truth.F.area_interval;
      for (const double area : {interval.open, (interval.open + interval.closed) / 2, interval.closed}) {
        if (area == truth.F.limit_area) continue;
        fast::Contact other = subj;
        other.F.area = area;
        const std::vector<Disagreement> found = disagreements(question, other, truth);
        ASSERT_EQ(found.size(), 1U) << axis << ' ' << distance << ' ' << area;
        EXPECT_EQ(found.front().kind, Kind::area);
        ++altered;
      }
      fast::Contact turned = subj;
      turned.E.vector_area_Me += Eigen::Vector3d(0, 1e-9, 0);
      EXPECT_EQ(disagreements(question, turned, truth).size(), 1U);
    }
  EXPECT_GE(altered, 30);
}

TEST(Verdict, FarFromUnitScaleRightAnswersPassAndAlteredOnesAreFlagged) {
  // Squares of forces and areas leave the range of doubles here.
  const SurfacePair pair = small_pair();
  for (const int exponent : {-200, 200}) {
    const double s = std::ldexp(1, exponent);
    TriangleMesh E = pair.E, F = pair.F;
    for (TriangleMesh* mesh : {&E, &F}) {
      for (Eigen::Vector3d& x : mesh->vertices) x *= s;
    }
    const HeldPairing held(E, F, ContactLaw{}, Mode::both);
    Pose pose;
    pose.A = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    pose.r = s * Eigen::Vector3d(0.3, 0.5, 0.2);
    fast::Workspace workspace;
    fast::Contact subj = fast::evaluate(held.engine(), pose, Velocity{}, Wanted{}, workspace);
    const Question question = held.question(pose, Velocity{});
    const reference::Answer truth = held.oracle().answer(reference::Problem::rounded, pose);
    EXPECT_EQ(disagreements(question, subj, truth).size(), 0U);
    subj.force_Me *= 1 + 1e-9;
    subj.torque_Me *= 1 + 1e-9;
    subj.E.vector_area_Me *= 1 + 1e-9;
    EXPECT_EQ(disagreements(question, subj, truth).size(), 4U);  // force and torque are no longer the elements' sums
    EXPECT_GT(*relative_errors(question, subj, truth, false).force, 0);
  }
}

TEST(Verdict, SliverInTheFoldOfASurfaceHasABoundThatIsNotNegative) {
  // The section of F is a figure of eight, whose smaller loop turns backwards: areas in it count negative.
  TriangleMesh F;
  for (const double z : {-1.0, 1.0}) {
    for (const auto& [x, y] :
         {std::pair{4.0, -4.0}, std::pair{4.0, 4.0}, std::pair{-1.0, -1.0}, std::pair{-1.0, 1.0}}) {
      F.vertices.emplace_back(x, y, z);
    }
  }
  F.faces = {{0, 3, 2}, {0, 2, 1}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
             {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  const double thin = 0x1p-52;
  const TriangleMesh E = generate::box(Eigen::Vector3d(-0.9, -0.1, -2), Eigen::Vector3d(-0.9 + thin, 0.1, 2));
  const HeldPairing held(E, F, ContactLaw{}, Mode::E);
  const Question question = held.question(Pose{}, Velocity{});
  const reference::Answer truth = held.oracle().answer(reference::Problem::rounded, Pose{});
  ASSERT_LT(truth.E.area, 0);
  const AreaBounds bounds = RoundingBounds(question, truth).area();
  EXPECT_GE(bounds.area_E, 0);
  EXPECT_GE(bounds.vector_area_E, 0);
  EXPECT_GE(bounds.volume, 0);
}

TEST(Verdict, PatchSmallerThanTheSpacingOfDoublesHasABound) {
  // So far from the origin that all crossings are stored as one point.
  const Eigen::Vector3d far(16430703938552922.0, 28533619582354000.0, -14813025922220390.0);
  TriangleMesh E, F;
  E.vertices = {{0, 0, 0},
                {-24790, 49288, -19066},
                {-44, -68, 32},
                {-14684, 29284, -11332},
                {-26504, 52704, -20388},
                {-25720, 51296, -19850}};
  for (Eigen::Vector3d& x : E.vertices) x += far;
  E.faces = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}};
  F.vertices = {{-7364, 14608, -5650}, {102494, 72460, 37666}, {-16658, 72456, 37666}, {-10170, 72456, 38440}};
  F.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const HeldPairing held(E, F, ContactLaw{}, Mode::E);
  Pose pose;
  pose.r = far;
  fast::Workspace workspace;
  const PoseOutcome outcome = held.hold(pose, Velocity{}, workspace).front();
  EXPECT_TRUE(outcome.touching);
  EXPECT_TRUE(outcome.disagreements.empty()) << outcome.disagreements.front().text;
}

TEST(Verdict, ThicknessOfClosedSurfacesIsVolumeOverMeanArea) {
  reference::Answer truth;
  truth.volume = 6;
  truth.E.area = 1;
  truth.F.area = 3;
  EXPECT_EQ(mean_thickness(truth), 3);
  truth.E.area = truth.F.area = 0;
  EXPECT_EQ(mean_thickness(truth), 0);
}

TEST(Verdict, ThicknessOfAnOpenPairIsItsPatchsDepthOrWidthWhicheverIsLess) {
  // A square patch of width w below which u is d: twice the volume w w d over the surface 2 w w + 4 w d.
  const auto thickness = [](double w, double d) {
    reference::Answer truth;
    reference::Polygon& outline = truth.polygons.emplace_back();
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, std::pair{w, 0.0}, std::pair{w, w}, std::pair{0.0, w}})
      outline.points.emplace_back().position_Me = {x, y, 0};
    for (const double part : {0.25, 0.75}) {
      reference::Element& element = truth.elements.emplace_back();
      element.area = part * w * w;
      element.penetration = d;
    }
    return mean_thickness(truth);
  };
  EXPECT_DOUBLE_EQ(thickness(1, 1), 1.0 / 3);
  EXPECT_NEAR(thickness(1, 0x1p-20), 0x1p-20, 0x1p-38);  // flat: its depth
  EXPECT_NEAR(thickness(0x1p-20, 1), 0x1p-21, 0x1p-39);  // a needle: half its width
  EXPECT_EQ(mean_thickness(reference::Answer{}), 0);     // no element
}

TEST(Verdict, StalePoseIsFlagged) {
  // The answer to the pose before is held against the truth of this one.
  const SurfacePair pair = small_pair();
  const HeldPairing held(pair.E, pair.F, pair.law, Mode::both);
  fast::Workspace workspace;
  fast::Contact stale;
  for (std::uint64_t i = 0; i <= 100; ++i) {
    const DrawnPose drawn = draw_pose(Stratum::generic, held.features(), PoseRandom(12, 0, 0, i));
    if (i > 0) {
      const reference::Answer truth = held.oracle().answer(reference::Problem::rounded, drawn.pose, drawn.velocity);
      EXPECT_FALSE(disagreements(held.question(drawn.pose, drawn.velocity), stale, truth).empty()) << i;
    }
    stale = fast::evaluate(held.engine(), drawn.pose, drawn.velocity, Wanted{}, workspace);
  }
}

SurfacePair pair_named(const std::string& name) {
  std::vector<std::string> missing;
  const std::vector<SurfacePair> pairs = built_in_pairs("", missing);
  const auto found =
      std::find_if(pairs.begin(), pairs.end(), [&](const SurfacePair& pair) { return pair.name == name; });
  if (found == pairs.end()) throw std::out_of_range("no pair " + name);
  return *found;
}

TEST(Verdict, SlaveNearlyParallelToTheLineOfAClampedElementAtRestHasABound) {
  // n_e . n_f is below its own rounding error, so the penetration has no bound; but it is clamped, and w = 0.
  VerificationPlan plan;
  plan.pairs = {pair_named("small icosphere-plate")};
  plan.strata = {Stratum::near_degenerate};
  plan.poses = 1;
  const Verification run(plan);
  const DrawnPose drawn = run.poses().draw(run.cells().front(), 3090);
  fast::Workspace workspace;
  const PoseOutcome outcome =
      run.poses().held_pairing(run.cells().front(), 3090).hold(drawn.pose, drawn.velocity, workspace).front();
  EXPECT_TRUE(outcome.disagreements.empty()) << outcome.disagreements.front().text;
  // It still is that pose.
  const HeldPairing& held = run.poses().held_pairing(run.cells().front(), 3090);
  Wanted wanted;
  wanted.bound = true;
  const fast::Contact& contact = fast::evaluate(held.engine(), drawn.pose, drawn.velocity, wanted, workspace);
  EXPECT_TRUE(drawn.velocity.w.isZero(0));
  EXPECT_TRUE(contact.penetration_exceeded);
  EXPECT_TRUE(contact.bound.value().force_Me.allFinite());
}

TEST(Verdict, TipThatCutsOfANeedleMasterLeaveBeyondItsCornerMayBeDeeperThanTheExactProblemIs) {
  // Corners of the slave face lie 10^6 times the master's width beside it, so that the weights where it is cut are off
  // by that many roundings (`pcm verify`, seed 19).
  const SurfacePair pair = pair_named("small icosphere-plate");
  VerificationPlan plan;
  plan.pairs = {pair};
  plan.strata = {Stratum::extreme};
  plan.schemes = {Scheme::clipped};
  plan.seed = 19;
  plan.poses = 1;
  const Verification run(plan);
  fast::Workspace workspace;
  for (const std::int64_t pose : {20172, 21648}) {
    const HeldPairing& held = run.poses().held_pairing(run.cells().front(), pose);
    const HeldPairing::State state = run.poses().asked(run.cells().front(), pose);
    Wanted wanted;
    wanted.bound = true;
    const fast::Contact& contact = fast::evaluate(held.engine_under(state.law, Mode::both, state.scheme), state.pose,
                                                  state.velocity, wanted, workspace);
    EXPECT_GT(contact.max_penetration, contact.bound->penetration_at_most) << pose;
    const PoseOutcome outcome = held.hold(state, workspace).front();
    EXPECT_TRUE(outcome.disagreements.empty()) << pose << ": " << outcome.disagreements.front().text;
    const AlteringSeam off([](fast::Contact& answer) {
      answer.max_penetration *= 1 + 1e-7;
      return true;
    });
    EXPECT_FALSE(held.hold(state, workspace, off).front().disagreements.empty()) << pose;
  }
}

TEST(Verdict, FacesUprightInAShearedBodysOwnFrameHideWhatTheyLeanOver) {
  // A may be a rotation to 1e-9 only: F's sides then lean over strips that wide beneath its other sides.
  const TriangleMesh E = generate::icosphere(1, 2), F = generate::box({1, 1, 1});
  const HeldPairing held(E, F, ContactLaw{}, HeldPairing::Modes{Mode::E, Mode::F, Mode::both}, Scheme::clipped);
  fast::Workspace workspace;
  for (const double shear : {-2e-10, -1e-12, 0.0, 1e-14, 1e-12, 2e-10}) {
    Pose pose;
    pose.A = Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    pose.A(0, 1) += shear;
    pose.A(2, 0) -= 0.5 * shear;
    pose.r = {0.3, 0.2, 0.9};
    for (const PoseOutcome& outcome : held.hold(pose, Velocity{}, workspace)) {
      EXPECT_TRUE(outcome.disagreements.empty()) << shear << ": " << outcome.disagreements.front().text;
      EXPECT_LT(*outcome.errors.force, 1e-15) << shear;
    }
  }
}

TEST(Verdict, NotANumberIsFlagged) {
  expect_always_flagged(Kind::volume, [](fast::Contact& subj) {
    subj.volume = std::numeric_limits<double>::quiet_NaN();
    return subj.has_volume;
  });
}

}  // namespace
}  // namespace pcm::compare
