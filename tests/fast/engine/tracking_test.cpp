// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/engine/tracking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "meshes/generate/parts.h"
#include "pcm/pairing_memory.h"
#include "pcm/scene.h"
#include "tests/fast/engine/tracked_walks.h"
#include "tests/fast/engine_support.h"

namespace pcm::fast {
namespace {

using Eigen::Vector3d;

using compare::kForceOnly;

TEST(Tracking, AnswersAlongAWalkAreThoseOfAnEngineWithoutAPast) {
  const test::WalkTally tally = test::take_walks(20261126, 2, 40);
  EXPECT_EQ(tally.different, 0) << tally.first_difference;
  EXPECT_GT(tally.touching, tally.evaluations / 3);
  EXPECT_GT(tally.followed, tally.touching / 4);
}

TEST(Tracking, ShortStepsNeedNoSearchFromTheRoots) {
  const Surface bubble(generate::bubble());
  const Pairing pairing(bubble, bubble, test::rough(1e5));
  PairingMemory memory(pairing);
  Workspace workspace;
  Pose pose = test::turned(0.3, {0.05, 0.1, 0.12});
  Savings off;
  off.coherence = false;
  std::int64_t searched = 0, searched_without = 0;
  for (int i = 0; i < 100; ++i) {
    pose.r.x() += 1e-6;
    searched += memory.evaluate(pose, {}, kForceOnly, workspace).work.candidate_pairs > 0 ? 1 : 0;
  }
  PairingMemory other(pairing);
  for (int i = 0; i < 100; ++i) {
    pose.r.x() += 1e-6;
    searched_without += other.evaluate(pose, {}, kForceOnly, workspace, off).work.candidate_pairs > 0 ? 1 : 0;
  }
  EXPECT_LT(searched, 12);
  EXPECT_EQ(searched_without, 100);
}

TEST(Tracking, ShortStepsAboutPlacesThatAreFarFromEachOtherNeedNoSearchFromTheRoots) {
  const Surface bubble(generate::bubble());
  const Pairing pairing(bubble, bubble, test::rough(1e5));
  PairingMemory memory(pairing);
  Workspace one, other;
  std::int64_t searched = 0;
  for (int place = 0; place < 20; ++place) {
    for (int i = 0; i < 5; ++i) {
      const Pose pose = test::turned(0.3, {0.05 + 2e-3 * place, 0.1, 0.12 + 1e-6 * i * (i % 2 == 0 ? 1 : -1)});
      const Contact& followed = memory.evaluate(pose, {}, kForceOnly, one);
      EXPECT_TRUE(test::same(followed, evaluate(pairing, pose, {}, kForceOnly, other))) << place << ' ' << i;
      searched += followed.work.candidate_pairs > 0 ? 1 : 0;
    }
  }
  // At each place once, and at the first one again after the first short step, before any was awaited.
  EXPECT_EQ(searched, 21);
}

TEST(Tracking, OneShortStepAmongLongOnesIsNotPreparedFor) {
  ShortSteps steps;
  for (int stage = 0; stage < 20; ++stage) {
    if (stage % 5 == 4) {
      steps.note_short(1e-6);
      EXPECT_FALSE(steps.others_follow()) << stage;
    } else {
      steps.note_long();
      EXPECT_FALSE(steps.awaited()) << stage;
    }
  }
}

TEST(Tracking, ShortStepsAreAwaitedAfterTheyCameTwice) {
  ShortSteps steps;
  for (int step = 0; step < 5; ++step) {
    steps.note_long();
    EXPECT_EQ(steps.awaited(), step >= 2) << step;
    EXPECT_EQ(steps.longest_awaited(), step == 0 ? 0 : 3e-6);
    for (const double way : {1e-6, 3e-6, 2e-6}) steps.note_short(way);
    EXPECT_TRUE(steps.others_follow());
  }
}

/// Where squares of areas leave the range of doubles, too.
TEST(Tracking, AnswersAlikeAtAllScales) {
  for (const int exponent : {-297, -280, -269, 0, 250}) {
    const double scale = std::ldexp(1.0, exponent);
    TriangleMesh mesh = generate::bubble();
    for (Vector3d& x : mesh.vertices) x *= scale;
    const Surface bubble(mesh);
    const Pairing pairing(bubble, bubble, test::stiffness(1), Mode::both);
    PairingMemory memory(pairing);
    Workspace one, other;
    int followed = 0;
    for (int i = 0; i < 150; ++i) {
      const double step = i < 100 ? 1e-5 : 1e-4;
      Pose pose = test::turned(0.3 + step * (i % 100), {0.05, 0.1, 0.12 + step * (i % 100)});
      pose.r *= scale;
      const Contact& answer = memory.evaluate(pose, {}, kForceOnly, one);
      followed += answer.touching && answer.work.candidate_pairs == 0 ? 1 : 0;
      ASSERT_TRUE(test::same(answer, evaluate(pairing, pose, {}, kForceOnly, other))) << exponent << ' ' << i;
    }
    EXPECT_GT(followed, 100) << exponent;
  }
}

/// A body and a speck far smaller than a step, each in one surface.
TriangleMesh with_speck(const TriangleMesh& body, const Vector3d& at, double size) {
  return degenerate::joined(body, translated(generate::icosphere(size, 0), at));
}

/// Nothing crosses before nor after it has gone in, but the speck lies within the other body.
TEST(Tracking, SpeckThatPassesThroughASurfaceBetweenPosesIsFound) {
  const TriangleMesh block = generate::gridded_box(1, 2);
  for (const bool speck_on_E : {false, true}) {
    const TriangleMesh large = with_speck(generate::gridded_box(1, 2), {0.8, 0.1, 0.2}, 1e-5);
    const Surface with(large), without(block);
    const Pairing pairing(speck_on_E ? with : without, speck_on_E ? without : with, test::stiffness(1), Mode::both);
    const double sign = speck_on_E ? -1 : 1;
    PairingMemory memory(pairing);
    Workspace one, other;
    int inside = 0;
    for (int i = 0; i < 40; ++i) {
      Pose pose;
      pose.r = sign * Vector3d(-0.27 - 0.0013 * i, 0.013, 0.007);
      const Contact& followed = memory.evaluate(pose, {}, kForceOnly, one);
      const Contact& anew = evaluate(pairing, pose, {}, kForceOnly, other);
      EXPECT_TRUE(test::same(followed, anew)) << i;
      inside += anew.nested ? 1 : 0;
    }
    EXPECT_GT(inside, 5);
    EXPECT_LT(inside, 35);
  }
}

/// A sheet within a block, an ear of which comes out through the middle of an upper face while a second sheet stands in
/// the lower side: no other pair comes near to crossing, and with that one the upper face gets its element.
TEST(Tracking, PairThatBeginsToCrossAloneIsFound) {
  TriangleMesh sheets;
  sheets.vertices = {{-1.8, -1.8, 0.5}, {1.8, -1.8, 0.5},  {1.8, 1.8, 0.5}, {-1.8, 1.8, 0.5}, {0.3, -1.2, 0.9995},
                     {1, 0.3, -1.25},   {1.1, 0.3, -0.95}, {1, 0.4, -0.85}, {1.1, 0.4, -0.55}};
  sheets.faces = {{0, 3, 2}, {0, 2, 1}, {0, 1, 4}, {5, 6, 7}, {7, 6, 8}};
  const Pairing pairing(Surface(generate::box({4, 4, 2})), Surface(sheets), test::stiffness(1), Mode::both);
  PairingMemory memory(pairing);
  Workspace one, other;
  int followed = 0;
  std::set<Index> elements;
  for (int i = 0; i < 100; ++i) {
    Pose pose;
    pose.r.z() = 1e-5 * i;
    const Contact& answer = memory.evaluate(pose, {}, kForceOnly, one);
    const Contact& anew = evaluate(pairing, pose, {}, kForceOnly, other);
    EXPECT_TRUE(test::same(answer, anew)) << i;
    followed += answer.work.candidate_pairs == 0 ? 1 : 0;
    elements.insert(anew.element_count);
  }
  EXPECT_GT(followed, 80);
  EXPECT_EQ(elements.size(), 2U);
}

/// Steps by which lines go on to find what they find for a while, and then the next face, or none.
TEST(Tracking, LinesThatGoOnToOtherFacesFindThem) {
  const Surface ball(generate::icosphere(1, 3)), rough(generate::bumpy_sphere(1, 0.1, 6, 40, 26));
  for (const auto& [E, F] : {std::pair(ball, ball), std::pair(rough, ball), std::pair(ball, rough)}) {
    const Pairing pairing(E, F, test::stiffness(1), Mode::both);
    for (const double step : {1e-5, 1e-4}) {
      PairingMemory memory(pairing);
      Workspace one, other;
      int followed = 0;
      std::int64_t lines = 0, settled = 0;
      for (int i = 0; i < 1000; ++i) {
        Pose pose = test::turned(0.3 + 0.5 * step * i, {0.2 + 0.3 * step * i, -0.1, 0.9 * step * i});
        pose.r *= 1.86 / pose.r.norm();
        const Contact& answer = memory.evaluate(pose, {}, kForceOnly, one);
        followed += answer.touching && answer.work.candidate_pairs == 0 ? 1 : 0;
        lines += answer.work.lines;
        settled += answer.work.lines_settled;
        ASSERT_TRUE(test::same(answer, evaluate(pairing, pose, {}, kForceOnly, other))) << step << ' ' << i;
      }
      EXPECT_GT(followed, 900);
      if (step < 5e-5) {
        EXPECT_GT(settled, lines / 4);
      }
      EXPECT_LT(settled, lines);
    }
  }
}

/// Plates one beneath the other, so that behind a face that a line leaves others are left.
TriangleMesh stacked_plates() {
  TriangleMesh plates = generate::plate(2, 2, 0.1, 6, 6);
  for (int k = 1; k < 4; ++k)
    plates = degenerate::joined(
        plates, translated(generate::plate(2, 2, 0.1, 5 + k, 5 + k), Vector3d(0.01 * k, 0.02 * k, -0.0137 * k)));
  return plates;
}

TEST(Tracking, LinesThroughStackedPlatesFindTheFirstOneThatTheyLeave) {
  compare::SurfacePair pair;
  pair.name = "stacked plates";
  pair.E = pair.F = stacked_plates();
  pair.law = test::stiffness(1);
  const Surface plates(pair.E);
  const Pairing pairing(plates, plates, pair.law, Mode::both);
  const compare::FeaturePair features(pair.E, pair.F);
  test::WalkTally tally;
  for (std::uint64_t walk = 0; walk < 20; ++walk)
    tally.add(test::take_walk(pair, compare::Stratum::generic, pairing, features, 20261127, walk, 60));
  EXPECT_EQ(tally.different, 0) << tally.first_difference;
  EXPECT_GT(tally.followed, 200);
}

/// Blocks that slide over each other, whose barycentres come to lie beneath edges and vertices of each other's grids,
/// exactly, for one pose: which face a line leaves through is the tie rule's to tell there, not the last pose's.
TEST(Tracking, LinesThatPassAnEdgeFindWhatTheTieRuleTells) {
  const Surface coarse(generate::gridded_box(6, 2)), fine(generate::gridded_box(12, 12));
  Wanted wanted = kForceOnly;
  wanted.elements = true;
  for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, -1, 0),
                              Vector3d(1, 0.5, 0), Vector3d(-0.5, -1, 0)}) {
    for (const auto& [E, F] : {std::pair(coarse, fine), std::pair(fine, coarse)}) {
      const Pairing pairing(E, F, test::stiffness(1), Mode::both);
      PairingMemory memory(pairing);
      Workspace one, other;
      int followed = 0;
      for (int i = -20; i <= 20; ++i) {
        const Pose pose{Eigen::Matrix3d::Identity(), 0x1p-10 * i * way + Vector3d(0, 0, 8)};
        const Contact& answer = memory.evaluate(pose, {}, wanted, one);
        followed += answer.work.candidate_pairs == 0 ? 1 : 0;
        ASSERT_TRUE(test::same(answer, evaluate(pairing, pose, {}, wanted, other))) << way.transpose() << ", " << i;
      }
      EXPECT_GT(followed, 35);
    }
  }
}

/// Three balls that roll on a plate, by all threads at once.
TEST(Tracking, ScenesFollowTheirPairingsAndAnswerAlike) {
  Savings off;
  off.coherence = false;
  Scene following, forgetful(off);
  for (Scene* const scene : {&following, &forgetful}) {
    const Index plate = scene->add_body(Surface(generate::plate(4, 4, 0.5, 8, 8)));
    for (int b = 0; b < 3; ++b) {
      const Index ball = scene->add_body(Surface(generate::icosphere(0.5, 3)));
      scene->add_pairing(plate, ball, test::rough(1e5), Mode::both, b == 1 ? Scheme::clipped : Scheme::barycentric,
                         kForceOnly);
    }
  }
  std::int64_t pairs_followed = 0, pairs_anew = 0;
  for (int step = 0; step < 60; ++step) {
    std::vector<BodyState> states(4);
    const double way = step < 30 ? 1e-4 * step : 3e-3 + 1e-9 * step;
    for (int b = 0; b < 3; ++b) {
      BodyState& state = states[static_cast<std::size_t>(b) + 1];
      state.pose.r = Vector3d(-1.2 + 1.2 * b + way, 0.1 * b, 0.49 - 0.01 * b);
      state.pose.A = Eigen::AngleAxisd(2 * way + b, Vector3d::UnitY()).toRotationMatrix();
      state.velocity.v = Vector3d(0.1, 0, -0.2);
    }
    for (Scene* const scene : {&following, &forgetful}) {
      scene->move(states);
      scene->evaluate_all(2, {});
    }
    for (Index p = 0; p < 3; ++p) {
      EXPECT_TRUE(following.load(p).touching);
      EXPECT_TRUE(test::same(following.load(p).force_Me, forgetful.load(p).force_Me)) << step;
      EXPECT_TRUE(test::same(following.load(p).torque_Me, forgetful.load(p).torque_Me)) << step;
    }
    pairs_followed += following.counters().work.candidate_pairs;
    pairs_anew += forgetful.counters().work.candidate_pairs;
  }
  EXPECT_LT(2 * pairs_followed, pairs_anew);
}

}  // namespace
}  // namespace pcm::fast
