// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/engine/separation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "fast/surface/prepared_surface.h"
#include "tests/fast/engine_support.h"

namespace pcm::fast {
namespace {

using Eigen::Vector3d;

double distance_bound(const Surface& E, const Surface& F, const Pose& pose) {
  BoxPairs stack;
  WorkCounters work;
  return distance_lower_bound(E.data(), F.data(), Placement(E.data(), F.data(), pose), stack, work);
}

TEST(DistanceLowerBound, OfBoxesFaceToFaceIsTheirDistanceToRounding) {
  const Surface box(generate::box({1, 1, 1}));
  for (const double gap : {1e-9, 1e-3, 0.25, 100.0}) {
    Pose pose;
    pose.r = {1 + gap, 0.125, 0.0625};
    const double bound = distance_bound(box, box, pose);
    EXPECT_LE(bound, pose.r.x() - 1);
    EXPECT_GE(bound, (pose.r.x() - 1) * (1 - 1e-6) - 1e-12);
  }
}

TEST(DistanceLowerBound, IsZeroWhereSurfacesTouchOrCross) {
  const Surface box(generate::box({1, 1, 1}));
  for (const double x : {1.0, 0.5, 0.0}) {
    Pose pose;
    pose.r = {x, 0.125, 0.0625};
    EXPECT_EQ(distance_bound(box, box, pose), 0);
  }
}

TEST(DistanceLowerBound, OfBallsNeverExceedsTheirDistanceAndIsAFairPartOfItBeyondTheSizeOfFaces) {
  const Surface ball(generate::icosphere(1, 4));
  std::mt19937_64 random(17);
  SCOPED_TRACE("seed 17");
  std::uniform_real_distribution<double> unit(-1, 1);
  int far = 0, fair = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d direction = Vector3d(unit(random), unit(random), unit(random)).normalized();
    const double gap = std::pow(10.0, -1.5 + 2 * unit(random));
    const Pose pose = test::turned(3 * unit(random), (2 + gap) * direction);
    // The meshes lie inside the balls, no vertex being off by more than a rounding; they sag by 0.002 at most.
    const double bound = distance_bound(ball, ball, pose);
    EXPECT_LE(bound, gap + 0.01);
    if (gap < 0.5) continue;
    ++far;
    fair += bound > gap / 3;
  }
  EXPECT_GT(far, 30);
  EXPECT_GT(fair, 0.9 * far);
}

TEST(SeparationCertificate, HoldsWhileTheWayIsLessThanTheDistanceAndNotLonger) {
  const Surface box(generate::box({1, 1, 1}));
  const BoundingBall ball(box.data());
  Pose pose;
  pose.r = {3, 0, 0};
  const SeparationCertificate certificate(pose, distance_bound(box, box, pose));
  const auto moved = [&](double way) {
    Pose now = pose;
    now.r.x() -= way;
    return certificate.holds(now, ball);
  };
  EXPECT_TRUE(moved(0));
  EXPECT_TRUE(moved(1.999));
  EXPECT_FALSE(moved(2.001));
  EXPECT_FALSE(SeparationCertificate().holds(pose, ball));
  Pose broken = pose;
  broken.r.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(certificate.holds(broken, ball));
}

TEST(SeparationCertificate, ThatHoldsIsNeverContradictedByTheEngine) {
  // Walks at random about each other: wherever the certificate holds, the surfaces are apart.
  const Surface bubble(generate::bubble()), socket(generate::gridded_box(0.3, 2));
  const Pairing pairing(bubble, socket);
  const BoundingBall ball(socket.data());
  Workspace workspace;
  std::mt19937_64 random(5);
  SCOPED_TRACE("seed 5");
  std::uniform_real_distribution<double> unit(-1, 1);
  int held = 0, touched = 0;
  for (int walk = 0; walk < 300; ++walk) {
    const Pose start = test::turned(3 * unit(random), Vector3d(unit(random), unit(random), unit(random)));
    if (evaluate(pairing, start, {}, {}, workspace).touching) continue;
    const double gap = distance_bound(bubble, socket, start);
    const SeparationCertificate certificate(start, gap);
    for (int step = 0; step < 20; ++step) {
      const double size = gap * std::abs(unit(random)) * 1.5;
      Pose now = test::turned(size * unit(random), size * Vector3d(unit(random), unit(random), unit(random)));
      now.r += now.A * start.r;
      now.A = now.A * start.A;
      const Contact& contact = evaluate(pairing, now, {}, {}, workspace);
      touched += contact.touching;
      if (!certificate.holds(now, ball)) continue;
      ++held;
      EXPECT_FALSE(contact.touching);
      EXPECT_FALSE(contact.nested);
    }
  }
  EXPECT_GT(held, 500);
  EXPECT_GT(touched, 5);
}

}  // namespace
}  // namespace pcm::fast
