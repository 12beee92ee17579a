// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/barycentric/line_margin.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

#include "fast/posed/motion.h"
#include "fast/predicates/penetration_predicates.h"

namespace pcm::fast {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
/// Margins are no greater than what is right, and less by a millionth of the lengths that they are differences of.
constexpr double kSharp = 1e-4;

DecidedLine decided(const FacePoints& master, const FacePoints& f) {
  const FaceGeometry geometry(master);
  const double a = (master[1] - master[0]).lpNorm<1>(), b = (master[2] - master[0]).lpNorm<1>();
  DecidedLine line{LineCoordinates(master, geometry.barycentre_Me(), a, b, 16), geometry, f};
  line.distance_error = 1e-9;
  line.greatest_of_slave = 1;
  return line;
}

/// The line leads downwards from (1, 1, 0). The slave's face lies `distance` beneath that, tilted out of the line's
/// direction about an axis through the line's point; seen along the line it is farther from the line than 1.34.
DecidedLine line_above(double distance, double tilt) {
  const double slope = std::tan(tilt);
  DecidedLine line = decided({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(0, 3, 0)},
                             {Eigen::Vector3d(1, -2, -distance), Eigen::Vector3d(-2, 4, -distance - 3 * slope),
                              Eigen::Vector3d(4, 4, -distance + 3 * slope)});
  line.element = distance > 0;
  line.thickness = 1000;
  line.slave_free = line.slave_free_travel = kNoLimit;
  return line;
}

void expect_travel(double expected, const DecidedLine& line, const LineMotion& motion = {}) {
  const double travel = travel_until_undecided(line, motion);
  EXPECT_LE(travel, expected);
  EXPECT_GE(travel, (1 - kSharp) * expected);
}

TEST(LineMargin, EndsWhereASideOfTheFaceMayComeToLieOnTheLine) {
  expect_travel(9 / std::hypot(3, 6), line_above(10, 0));
  expect_travel(9 / std::hypot(3, 6), line_above(-10, 0));
}

TEST(LineMargin, EndsWhereTheFaceMayPassTheLinesOrigin) {
  for (const double tilt : {0.0, 0.3, 0.9, 1.2})
    for (const double distance : {0.5, -0.5}) expect_travel(0.5 * std::cos(tilt), line_above(distance, tilt));
}

TEST(LineMargin, EndsWhereTheLineMayBeLongerThanTheMasterIsThick) {
  for (const double tilt : {0.0, 0.3, 0.9}) {
    DecidedLine line = line_above(5, tilt);
    line.thickness = 5.25;
    expect_travel(0.25 * std::cos(tilt), line);
    line.thickness = 5;
    EXPECT_EQ(travel_until_undecided(line, {}), 0);
  }
}

TEST(LineMargin, EndsWhereTheOriginMayBeDeeperThanTheFaceIsClear) {
  for (const double tilt : {0.0, 0.3, 0.8}) {
    DecidedLine line = line_above(5, tilt);
    line.slave_free = 0;
    line.greatest_of_slave = 8;
    const std::size_t cone = tilt < 0.5 ? 0 : 1;
    line.clearance.beneath[cone] = static_cast<float>((5 * std::cos(tilt) + 0.25) / 8);
    expect_travel(8 * static_cast<double>(line.clearance.beneath[cone]) - 5 * std::cos(tilt), line, {1, 1e9});
    // A turn makes the line's origin deeper, too.
    EXPECT_LT(travel_until_undecided(line, {1, 10}), 0.25 / 2 * (1 + kSharp));
  }
}

TEST(LineMargin, EndsWhereTheLineMayTurnOutOfTheCone) {
  for (const double distance : {5.0, -5.0}) {
    DecidedLine line = line_above(distance, std::acos(0.8));
    line.slave_free = 0;
    line.clearance.beneath[0] = 100;
    line.clearance.above[0] = true;
    expect_travel(0.01 * 7, line, {1, 7});
    line.clearance.beneath[1] = 100;
    line.clearance.above[1] = true;
    expect_travel((0.8 - 0.652) * 7, line, {1, 7});
  }
}

TEST(LineMargin, EndsWhereWhatIsKnownOfOtherFacesMay) {
  for (const double tilt : {0.0, 0.9}) {
    DecidedLine line = line_above(5, tilt);
    line.slave_free = 5.25;
    expect_travel(0.25 * std::cos(tilt), line);
    line.slave_free_travel = 0.0625;
    expect_travel(0.0625, line);
    DecidedLine behind = line_above(-5, tilt);
    behind.slave_free_travel = 0.0625;
    expect_travel(0.0625, behind);
    behind.slave_free = 1000;
    EXPECT_EQ(travel_until_undecided(behind, {}), 0);
  }
}

TEST(LineMargin, IsShorterWhereTheSlaveMovesFartherThanPointsOfF) {
  expect_travel(0.125, line_above(0.5, 0), {4, 1});
  DecidedLine line = line_above(0.5, 0);
  line.slave_free_travel = 0.0625;
  expect_travel(0.0625, line, {4, 1});
}

TEST(LineMargin, IsNoneWithoutACertificateOrWhereNumbersTellNothing) {
  DecidedLine line = line_above(5, 0);
  line.slave_free = 0;
  EXPECT_EQ(travel_until_undecided(line, {1, kNoLimit}), 0);
  for (const double x : {1 + 0x1p-44, 1.0}) {  // a side of the face on the line, or beside it
    const DecidedLine on_side =
        decided({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(0, 3, 0)},
                {Eigen::Vector3d(x, 5, -1), Eigen::Vector3d(4, 0, -1), Eigen::Vector3d(x, -2, -1)});
    EXPECT_EQ(travel_until_undecided(on_side, {}), 0);
  }
  DecidedLine huge = line_above(5, 0);
  for (Eigen::Vector3d& x : huge.f_Me) x *= 0x1p900;
  EXPECT_EQ(travel_until_undecided(huge, {}), 0);
}

/// A rigid motion, near or far from the one that brings what is near to the line's face soonest.
Pose motion_towards(const Eigen::Vector3d& way, double far, std::mt19937_64& random) {
  std::uniform_real_distribution<double> number{-1, 1};
  const auto draw = [&] { return Eigen::Vector3d(number(random), number(random), number(random)); };
  Pose to;
  to.r = way + 0.1 * far * draw();
  to.A = Eigen::AngleAxisd(0.2 * far * number(random), draw().normalized()).toRotationMatrix();
  return to;
}

// Whatever the slave's face does meanwhile: it is F's here, and the master E's.
TEST(LineMargin, WithinItTheLinePassesThroughTheFaceOnTheSameSideExactly) {
  std::mt19937_64 random{1128};
  SCOPED_TRACE("seed 1128");
  std::uniform_real_distribution<double> number{-1, 1};
  const auto draw = [&] { return Eigen::Vector3d(number(random), number(random), number(random)); };
  int settled = 0, held = 0, ends = 0;
  while (settled < 20000) {
    const FacePoints master{draw(), draw(), draw()};
    const FaceGeometry geometry(master);
    const Eigen::Vector3d pierced = geometry.barycentre_Me() - number(random) * geometry.n_Me;
    const FacePoints f{pierced + draw(), pierced + draw(), pierced + draw()};
    const PenetrationLine exact(master[0], master[1], master[2]);
    WorkCounters work;
    if (facing(exact, f, work) != -1 || !passes_through(exact, f, work)) continue;
    const int side = distance_sign(exact, f, work);
    DecidedLine line = decided(master, f);
    line.element = side > 0;
    line.thickness = line.slave_free = line.slave_free_travel = kNoLimit;
    const double travel = travel_until_undecided(line, {});
    if (!(travel > 0x1p-20)) continue;
    ++settled;
    // Towards the nearest side, or along the face's normal towards the line's origin, or anywhere.
    const Eigen::Vector3d n_f = (f[1] - f[0]).cross(f[2] - f[0]).normalized();
    Eigen::Vector3d way = -side * n_f;
    if (settled % 3 == 0) {
      way = draw();
    } else if (settled % 3 == 1) {
      double nearest = kNoLimit;
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d across = (f[(k + 1) % 3] - f[k]).cross(geometry.n_Me).normalized();
        const double distance = across.dot(geometry.barycentre_Me() - f[k]);
        if (std::abs(distance) < nearest) way = distance > 0 ? across : -across;
        nearest = std::min(nearest, std::abs(distance));
      }
    }
    const Eigen::Vector3d low = f[0].cwiseMin(f[1]).cwiseMin(f[2]), high = f[0].cwiseMax(f[1]).cwiseMax(f[2]);
    const BoundingBall ball = ball_about(low, high);
    const auto moved_by = [&](double way_length) {
      const bool turns = settled % 2 == 0;
      // Where it turns, points of the ball travel up to some three times as far as its centre does.
      const Pose to = motion_towards((turns ? 0.4 : 1) * way_length * way.normalized(), turns ? way_length : 0, random);
      FacePoints moved;
      for (std::size_t k = 0; k < 3; ++k) moved[k] = to.A * f[k] + to.r;
      return std::pair(moved, greatest_travel({}, to, ball));
    };
    const auto stays = [&](const FacePoints& moved) {
      return facing(exact, moved, work) == -1 && passes_through(exact, moved, work) &&
             distance_sign(exact, moved, work) == side;
    };
    const auto [near, travelled] = moved_by((1 - 0x1p-16) * travel);
    if (travelled < travel) {
      EXPECT_TRUE(stays(near)) << settled;
      ++held;
    }
    ends += !stays(moved_by(1.001 * travel).first);
  }
  EXPECT_GT(held, 15000);
  EXPECT_GT(ends, 400) << "sides that are slanted along the line count with their whole length, but not all are";
}

}  // namespace
}  // namespace pcm::fast
