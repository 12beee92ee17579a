// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison itself is tested: right answers pass, answers altered on purpose are flagged, runs repeat and resume.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "compare/io/program_hash.h"
#include "compare/io/sha256.h"
#include "compare/verify/rounding_bounds.h"
#include "compare/verify/summary.h"
#include "compare/verify/verification_table.h"
#include "compare/verify/verify.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/lattice_tetrahedra.h"
#include "meshes/generate/round.h"
#include "pcm/bad_input.h"
#include "tests/compare/small_pair.h"
#include "tests/compare/verify/altering_seam.h"

namespace pcm::compare {
namespace {

const auto kNever = [] { return false; };
const auto kSilent = [](std::int64_t) {};

VerificationPlan small_plan(std::int64_t poses) {
  VerificationPlan plan;
  plan.poses = poses;
  plan.pairs = {small_pair()};
  return plan;
}

void run_all(Verification& run, int jobs) {
  while (!run.finished()) run.run_batch(jobs, kNever, kSilent);
}

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

TEST(Verdict, SlaveNearlyParallelToTheLineOfAClampedElementAtRestHasABound) {
  // n_e . n_f is below its own rounding error, so the penetration has no bound; but it is clamped, and w = 0.
  std::vector<std::string> missing;
  for (const SurfacePair& pair : built_in_pairs("", missing)) {
    if (pair.name != "small icosphere-plate") continue;
    VerificationPlan plan;
    plan.pairs = {pair};
    plan.strata = {Stratum::near_degenerate};
    plan.poses = 1;
    const Verification run(plan);
    const DrawnPose drawn = run.draw(run.cells().front(), 3090);
    fast::Workspace workspace;
    const PoseOutcome outcome =
        run.held_pairing(run.cells().front(), 3090).hold(drawn.pose, drawn.velocity, workspace).front();
    EXPECT_TRUE(outcome.disagreements.empty()) << outcome.disagreements.front().text;
    return;
  }
  FAIL() << "no such pair";
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

TEST(Verification, SmallPairAgreesInEveryStratum) {
  Verification run(small_plan(600));
  run_all(run, 2);
  const Tally total = run.total();
  EXPECT_EQ(total.poses, 600);
  EXPECT_EQ(total.disagreeing, 0);
  for (const Finding& finding : run.findings())
    for (const Disagreement& d : finding.disagreements)
      ADD_FAILURE() << run.pose_name(run.cells()[finding.cell], finding.pose) << ": " << name(d.kind) << ": " << d.text;
  for (const Cell& cell : run.cells()) {
    const double touching = static_cast<double>(cell.tally.touching) / static_cast<double>(cell.poses);
    if (cell.stratum == Stratum::separated || cell.stratum == Stratum::nested) {
      EXPECT_EQ(cell.tally.touching, 0) << name(cell.stratum);
    } else {
      EXPECT_GE(touching, 0.5) << name(cell.stratum);
    }
    if (cell.stratum == Stratum::nested) {
      EXPECT_EQ(cell.tally.nested, cell.poses);
    }
  }
}

TEST(Verification, ErrorsAboveTheMeasureAreNamedWithTheirPercentile) {
  VerificationPlan plan = small_plan(240);
  plan.strata = {Stratum::generic};
  Verification right(plan);
  run_all(right, 2);
  EXPECT_FALSE(missed_measure(right).has_value());

  const AlteringSeam deeper([](fast::Contact& contact) {
    contact.max_penetration *= 1 + 1e-10;
    return true;
  });
  Verification wrong(plan, deeper);
  run_all(wrong, 1);
  const std::optional<MissedMeasure> missed = missed_measure(wrong);
  ASSERT_TRUE(missed.has_value());
  EXPECT_EQ(missed->what, "penetration");
  EXPECT_NE(verdict_line(wrong).find("at the 99th percentile"), std::string::npos) << verdict_line(wrong);

  const AlteringSeam wider([](fast::Contact& contact) {
    contact.volume *= 1 + 1e-10;
    return true;
  });
  Verification too_wide(plan, wider);
  run_all(too_wide, 1);
  EXPECT_NE(verdict_line(too_wide).find("volume error"), std::string::npos) << verdict_line(too_wide);
  EXPECT_NE(verdict_line(too_wide).find("at the 99.9th percentile"), std::string::npos);
}

TEST(Verification, PosesOfAPairWithVariantsTakeThemInTurn) {
  VerificationPlan plan;
  plan.poses = 60;
  plan.strata = {Stratum::degenerate};
  SurfacePair& pair = plan.pairs.emplace_back(small_pair());
  for (const std::uint64_t number : {0, 2}) pair.variants.push_back(degenerate::lattice_tetrahedra(number));
  Verification run(plan);
  const Cell& cell = run.cells().front();
  std::vector<std::vector<Eigen::Vector3d>> expected = {pair.E.vertices, pair.variants[0][0].vertices,
                                                        pair.variants[1][0].vertices};
  for (std::int64_t pose = 0; pose < 6; ++pose) {
    EXPECT_EQ(run.held_pairing(cell, pose).features().E.mesh.vertices, expected[static_cast<std::size_t>(pose % 3)])
        << pose;
    EXPECT_EQ(run.as_case({0, pose, {}}).E.vertices, expected[static_cast<std::size_t>(pose % 3)]) << pose;
  }
  run_all(run, 2);
  EXPECT_EQ(run.total().disagreeing, 0);
  EXPECT_GT(run.total().touching, 30);
}

TEST(Verification, TablesDoNotDependOnTheNumberOfThreads) {
  Verification one(small_plan(240)), four(small_plan(240));
  run_all(one, 1);
  run_all(four, 4);
  EXPECT_EQ(verification_markdown(one), verification_markdown(four));
  EXPECT_EQ(verification_csv(one), verification_csv(four));
  EXPECT_EQ(verification_json(one), verification_json(four));
}

TEST(Verification, AllModesTogetherAnswerAsThreeRunsBitForBit) {
  for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
    VerificationPlan plan = small_plan(60);
    plan.schemes = {scheme};
    plan.modes = {Mode::E, Mode::F, Mode::both};
    Verification together(plan);
    run_all(together, 2);
    EXPECT_EQ(together.poses_done(), 60);
    EXPECT_EQ(together.total().poses, 180);
    const auto answers = [](const Tally& tally) {
      nlohmann::ordered_json json = tally.to_json();
      json.erase("seconds");
      return json;
    };
    for (std::size_t m = 0; m < 3; ++m) {
      plan.modes = {std::vector{Mode::E, Mode::F, Mode::both}[m]};
      Verification alone(plan);
      run_all(alone, 2);
      EXPECT_EQ(answers(together.by_mode()[m].tally), answers(alone.total()));
      ASSERT_EQ(together.cells().size(), 3 * alone.cells().size());
      for (std::size_t c = 0; c < alone.cells().size(); ++c) {
        EXPECT_EQ(together.cells()[3 * c + m].mode, plan.modes.front());
        EXPECT_EQ(answers(together.cells()[3 * c + m].tally), answers(alone.cells()[c].tally));
      }
      EXPECT_THROW(alone.restore(together.state()), BadInput);
    }
    Verification continued(together.plan());
    continued.restore(together.state());
    EXPECT_EQ(verification_csv(continued), verification_csv(together));
    EXPECT_EQ(verification_markdown(continued), verification_markdown(together));
    EXPECT_NE(verdict_line(together).find("60 poses in 3 modes"), std::string::npos);
  }
}

TEST(Verification, ContinuedRunEndsLikeAnUninterruptedOne) {
  VerificationPlan plan = small_plan(2500);
  plan.strata = {Stratum::separated};
  Verification whole(plan), first(plan), second(plan);
  ASSERT_GT(whole.batches(), 2);
  run_all(whole, 2);
  first.run_batch(2, kNever, kSilent);
  const auto state = nlohmann::ordered_json::parse(first.state().dump());
  second.restore(state);
  EXPECT_EQ(second.poses_done(), first.poses_done());
  run_all(second, 2);
  EXPECT_EQ(verification_csv(second), verification_csv(whole));

  plan.seed = 2;
  Verification other(plan);
  EXPECT_THROW(other.restore(state), BadInput);
}

TEST(Verification, InterruptedBatchKeepsWhatItHasAndIsNotDone) {
  Verification run(small_plan(240));
  int asked = 0;
  run.run_batch(
      1, [&] { return ++asked > 10; }, kSilent);
  EXPECT_EQ(run.poses_done(), 10);
  EXPECT_EQ(run.batches_done(), 0);
  EXPECT_TRUE(verdict_line(run).starts_with("unfinished: 10 poses")) << verdict_line(run);
  EXPECT_NE(verdict_line(run).find("interrupted"), std::string::npos);
  EXPECT_FALSE(is_verified(run));

  Verification continued(run.plan()), whole(run.plan());
  continued.restore(nlohmann::ordered_json::parse(run.state().dump()));
  EXPECT_EQ(continued.poses_done(), 10);
  run_all(continued, 2);
  run_all(whole, 1);
  EXPECT_EQ(continued.poses_done(), 240);
  EXPECT_EQ(verification_csv(continued), verification_csv(whole));
}

/// A plan of both schemes, two pairs and all strata.
VerificationPlan plan_of_both_schemes(std::int64_t poses) {
  VerificationPlan plan = small_plan(poses);
  plan.schemes = {Scheme::barycentric, Scheme::clipped};
  SurfacePair& second = plan.pairs.emplace_back(small_pair());
  second.name = "the other pair";
  std::swap(second.E, second.F);
  return plan;
}

TEST(Verification, NoPoseOfAPairAndStratumIsAskedTwice) {
  const Verification run(plan_of_both_schemes(1800));
  std::map<std::pair<std::size_t, Stratum>, std::set<std::int64_t>> numbers;
  std::set<std::vector<double>> states;
  std::size_t poses = 0, generic = 0;
  for (const Cell& cell : run.cells())
    for (std::int64_t pose = cell.first; pose < cell.first + cell.poses; ++pose) {
      ++poses;
      EXPECT_TRUE(numbers[std::pair(cell.pair, cell.stratum)].insert(pose).second) << run.pose_name(cell, pose);
      if (cell.stratum != Stratum::generic) continue;  // of the others some may be in one place by chance
      ++generic;
      const HeldPairing::State state = run.asked(cell, pose);
      states.insert({state.pose.r.x(), state.pose.r.y(), state.pose.r.z(), state.law.stiffness, state.law.damping,
                     state.law.friction});
    }
  EXPECT_EQ(poses, 1800U);
  EXPECT_EQ(states.size(), generic);
  for (const auto& [key, found] : numbers)
    EXPECT_EQ(*found.rbegin() + 1, std::ssize(found)) << "numbers from 0 on without a gap";
  EXPECT_EQ(run.cells().front().first, 0);
}

TEST(Verification, PosesOfOneSchemeAloneAreNumberedFromZero) {
  VerificationPlan plan = plan_of_both_schemes(60);
  plan.schemes = {Scheme::clipped};
  const Verification run(plan);
  for (const Cell& cell : run.cells()) EXPECT_EQ(cell.first, 0);
}

TEST(Verification, FindingsOfTheClippedSchemeAreThePosesThatWereAsked) {
  VerificationPlan plan = plan_of_both_schemes(120);
  plan.strata = {Stratum::generic};
  const Verification run(plan);
  const auto clipped = std::find_if(run.cells().begin(), run.cells().end(),
                                    [](const Cell& cell) { return cell.scheme == Scheme::clipped; });
  ASSERT_NE(clipped, run.cells().end());
  ASSERT_GT(clipped->first, 0);
  const Case posed = run.as_case({static_cast<std::size_t>(clipped - run.cells().begin()), clipped->first, {}});
  EXPECT_EQ(posed.scheme, Scheme::clipped);
  EXPECT_EQ(posed.pose.r, run.draw(*clipped, clipped->first).pose.r);
  EXPECT_NE(posed.origin.find(std::to_string(clipped->first) + "/both/clipped"), std::string::npos) << posed.origin;
}

bool any_says(const std::vector<std::string>& lines, const std::string& words) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

TEST(Verification, WhatIsNamedMustGetAPose) {
  // A pose a stratum: the second pair gets all of them.
  const VerificationPlan plan = plan_of_both_schemes(6);
  const auto expect_refused = [](const VerificationPlan& named, const std::string& what) {
    try {
      const Verification run(named);
      ADD_FAILURE() << what << " got no pose, and nobody said so";
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  VerificationPlan pairs = plan, schemes = plan, strata = plan, nested = plan;
  pairs.pairs_named = true;
  expect_refused(pairs, "pair " + small_pair().name);
  schemes.schemes_named = true;
  expect_refused(schemes, "clipped scheme");
  strata.strata_named = true;
  strata.poses = 5;
  expect_refused(strata, "stratum generic");
  nested.strata_named = true;
  for (SurfacePair& pair : nested.pairs)
    for (TriangleMesh* mesh : {&pair.E, &pair.F}) mesh->faces.pop_back();  // open, so that nothing is inside
  expect_refused(nested, "stratum nested gets no pose: it is not to be had");
}

TEST(Verification, WhatGetsNoPoseIsSaidInTablesAndVerdict) {
  Verification run(plan_of_both_schemes(5));
  run_all(run, 1);
  for (const std::string& words : {std::string("stratum generic"), std::string("clipped scheme"),
                                   "1 of 2 pairs get no pose (" + small_pair().name}) {
    EXPECT_TRUE(any_says(run.omissions(), words)) << words;
    EXPECT_NE(verification_summary(run).find(words), std::string::npos) << words;
    EXPECT_NE(verification_markdown(run).find(words), std::string::npos) << words;
  }
  EXPECT_NE(verdict_line(run).find("(no pose: generic; clipped scheme; 1 of 2 pairs)"), std::string::npos)
      << verdict_line(run);
  const Verification enough(plan_of_both_schemes(120));
  EXPECT_EQ(enough.without_poses(), "");
  EXPECT_TRUE(enough.omissions().empty()) << enough.omissions().front();
}

/// Breaks down, by no BadInput, when a law is drawn at some poses.
class BreakingSeam final : public EngineSeam {
 public:
  const fast::Contact& evaluate_for_draw(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                         const Wanted& wanted, fast::Workspace& workspace) const override {
    if (pose.r.x() > 0) throw std::logic_error("out of order");
    return EngineSeam::evaluate_for_draw(pairing, pose, velocity, wanted, workspace);
  }
};

TEST(Verification, EngineThatBreaksDownWhileALawIsDrawnFailsThatPoseAndHasACase) {
  VerificationPlan plan = small_plan(60);
  plan.strata = {Stratum::generic};
  plan.modes = {Mode::E, Mode::both};
  const BreakingSeam seam;
  Verification run(plan, seam);
  run_all(run, 2);
  EXPECT_EQ(run.poses_done(), 60);
  const Tally total = run.total();
  EXPECT_GT(total.disagreeing, 0);
  EXPECT_LT(total.disagreeing, total.poses);
  EXPECT_EQ(total.by_kind[static_cast<std::size_t>(Kind::failure)], total.disagreeing);
  ASSERT_FALSE(run.findings().empty());
  const Finding& finding = run.findings().front();
  EXPECT_NE(finding.disagreements.front().text.find("out of order"), std::string::npos);
  const Case posed = run.as_case(finding);
  EXPECT_EQ(posed.mode, Mode::both);
  EXPECT_GT(posed.pose.r.x(), 0);
  EXPECT_TRUE(verdict_line(run).starts_with("NOT verified")) << verdict_line(run);
}

TEST(Verification, PosesThatNoSceneIsAskedAboutAreCountedAndKept) {
  VerificationPlan plan = small_plan(600);
  plan.strata = {Stratum::near_degenerate};
  plan.modes = {Mode::E, Mode::F};
  Verification run(plan);
  run_all(run, 2);
  std::int64_t skipped = 0;
  const Cell& cell = run.cells().front();
  for (std::int64_t pose = 0; pose < cell.poses; ++pose) skipped += !is_pose_for_scenes(run.asked(cell, pose).pose);
  ASSERT_GT(skipped, 0);
  const std::string words = "no scene was asked about " + std::to_string(skipped) + " of 600 poses";
  EXPECT_NE(verification_summary(run).find(words), std::string::npos) << without_scene_line(run);
  EXPECT_NE(verification_markdown(run).find(words), std::string::npos);
  EXPECT_EQ(verification_json(run)["without_scene"]["near-degenerate"], skipped);
  Verification continued(plan);
  continued.restore(nlohmann::ordered_json::parse(run.state().dump()));
  EXPECT_EQ(without_scene_line(continued), without_scene_line(run));
}

/// The switches of a question, as text.
std::string switches(const Ask& ask) {
  const Wanted& w = ask.wanted;
  const fast::Savings& s = ask.savings;
  std::string text;
  for (const bool x : {w.polygons, w.areas, w.force, w.elements, w.bound, w.statistics, s.broad_phase, s.certificates,
                       s.first_crossing, s.lazy_vertices, s.one_sided, s.velocities, s.only_wanted, s.filters})
    text += x ? '1' : '0';
  return text;
}

TEST(CallRoutes, CoarseStatesAtRestDrawAllSwitchesBothWaysInEvaluateAndInScenes) {
  // Their doubles differ in few bits, all of them high ones.
  std::map<Route, std::set<std::string>> drawn;
  std::map<Route, std::array<int, 14>> on;
  bool differ = false;
  constexpr int kStates = 512;
  for (int k = 0; k < kStates; ++k) {
    Pose pose;
    pose.r = Eigen::Vector3d(k % 8, k / 8 % 8, k / 64) / 8;
    const std::vector<Ask> plain = asks_at(pose, Velocity{}), pairings = scene_asks_at(pose, Velocity{});
    ASSERT_EQ(pairings.size(), 2U);
    EXPECT_EQ(switches(pairings.front()), switches(Ask{}));
    for (const Ask& ask : {plain.back(), pairings.back()}) {
      const std::string text = switches(ask);
      drawn[ask.route].insert(text);
      for (std::size_t i = 0; i < text.size(); ++i) on[ask.route][i] += text[i] == '1';
    }
    differ |= switches(plain.back()) != switches(pairings.back());
  }
  EXPECT_TRUE(differ);
  for (const Route route : {Route::drawn, Route::scene}) {
    // Of 2^14 choices: 512 draws meet some 8 of them twice.
    EXPECT_GE(drawn[route].size(), 490U) << name(route);
    // Five standard deviations.
    for (const int count : on[route]) EXPECT_NEAR(count, kStates / 2, 57) << name(route);
  }
}

TEST(ProgramHash, ProgramThatCantBeReadIsBadInput) {
  EXPECT_THROW(program_hash_of("/no/such/proc/self/exe"), BadInput);
  EXPECT_EQ(program_hash_of("/proc/self/exe"), program_hash());
}

TEST(Tally, BoundOnTheRateIsThreeOverNWithoutDisagreements) {
  Tally tally;
  PoseOutcome outcome;
  for (int k = 0; k < 1000; ++k) tally.add(outcome, std::to_string(k));
  EXPECT_NEAR(tally.disagreement_rate_bound(), 0.002991, 1e-6);  // 1 - 0.05^(1 / 1000)
}

TEST(Tally, QuantilesAreRoundedUpByA64thAtMost) {
  Histogram histogram;
  for (int k = 1; k <= 1000; ++k) histogram.add(1e-17 * k);
  for (const double q : {0.5, 0.99, 0.999, 1.0}) {
    EXPECT_GE(histogram.quantile(q), 1e-14 * q * (1 - 1e-12));
    EXPECT_LE(histogram.quantile(q), 1e-14 * q * (1 + 1.0 / 64) * (1 + 1e-12));
  }
  EXPECT_EQ(Histogram().quantile(0.5), 0);
}

TEST(Tally, WhatIsNoFiniteNumberIsGreaterThanAllOthers) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double no_number : {kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    Histogram histogram;
    for (int k = 0; k < 9; ++k) histogram.add(std::numeric_limits<double>::max());
    histogram.add(no_number);
    EXPECT_EQ(histogram.quantile(0.9), std::numeric_limits<double>::max());
    EXPECT_EQ(histogram.quantile(1), kInfinity);
    PoseOutcome outcome;
    outcome.errors.force = 1;
    Tally tally;
    tally.add(outcome, "a");
    outcome.errors.force = no_number;
    tally.add(outcome, "b");
    const Tally again = Tally::from_json(nlohmann::ordered_json::parse(tally.to_json().dump()));
    for (const Tally& known : {tally, again}) {
      EXPECT_EQ(known.worst[4].value, kInfinity);
      EXPECT_EQ(known.worst[4].pose, "b");
      EXPECT_EQ(known.error_quantile(4, 1), kInfinity);
    }
  }
}

TEST(Tally, ChecksOfZeroAreCountedApartAndNotAsInfinite) {
  Checks checks;
  checks.check_value(Kind::force, "a", 0, 0, 0, 0);     // nothing to hold
  checks.check_value(Kind::force, "b", 0, 0, 1e-3, 0);  // of 0
  checks.check_value(Kind::force, "c", 2, 2, 1e-3, 2);
  checks.check_value(Kind::force, "d", 2, 2, std::numeric_limits<double>::infinity(), 0);
  checks.check_value(Kind::force, "e", 1e-320, 1e-320, 1, 1e-320);  // finite, though no double tells it
  Widths widths;
  for (const Width& width : checks.widths()) widths.add(width);
  EXPECT_EQ(widths.count(), 4);
  EXPECT_EQ(widths.of_zero, 1);
  EXPECT_EQ(widths.infinite, 1);
  EXPECT_EQ(widths.wider, 1);
  EXPECT_NEAR(widths.quantile(0.3), 5e-4, 5e-4 / 64);
  EXPECT_EQ(widths.quantile(0.6), std::numeric_limits<double>::max());
  EXPECT_EQ(widths.quantile(1), std::numeric_limits<double>::infinity());
}

TEST(Checks, NoNumberDisagreesWhereverItStands) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  const auto agrees = [](double subj, double truth, double bound) {
    Checks of_number, of_vector;
    of_number.check_value(Kind::force, "number", subj, truth, bound, 1);
    of_vector.check_vector(Kind::force, "vector", {0, subj, 0}, {0, truth, 0}, bound, 1);
    EXPECT_EQ(of_number.disagreements().empty(), of_vector.disagreements().empty());
    return of_number.disagreements().empty();
  };
  EXPECT_TRUE(agrees(1, 1, 0));
  EXPECT_TRUE(agrees(kInfinity, kInfinity, 0));
  EXPECT_FALSE(agrees(kInfinity, -kInfinity, 1));
  EXPECT_FALSE(agrees(kNaN, 1, kInfinity));
  EXPECT_FALSE(agrees(1, kNaN, kInfinity));
  EXPECT_FALSE(agrees(1, 1, kNaN));
  EXPECT_FALSE(agrees(kInfinity, kInfinity, kNaN));
}

TEST(Sha256, KnownDigests) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace pcm::compare
