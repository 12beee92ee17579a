// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcm/load_tangent.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "tests/simbody/rough_law.h"

namespace pcm::simbody {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

struct Motion {
  Pose pose;
  Velocity velocity;
};

/// Turned about Mf's origin by Rodrigues' formula, I + sin K + (1 - cos) K^2.
Motion displaced(Motion motion, int coordinate, double change) {
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(coordinate % 3);
  Eigen::Matrix3d K;
  K << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  const Eigen::Matrix3d R = Eigen::Matrix3d::Identity() + std::sin(change) * K + (1 - std::cos(change)) * K * K;
  if (coordinate < 3) motion.pose.r += change * axis;
  if (coordinate >= 3 && coordinate < 6) motion.pose.A = R * motion.pose.A;
  if (coordinate >= 6 && coordinate < 9) motion.velocity.v += change * axis;
  if (coordinate >= 9) motion.velocity.w += change * axis;
  return motion;
}

Load load_at(const fast::Pairing& pairing, const Motion& motion) {
  fast::Workspace workspace;
  const fast::Contact& contact = fast::evaluate(pairing, motion.pose, motion.velocity, {}, workspace);
  Load load;
  load << contact.force_Me, contact.torque_Me;
  return load;
}

TangentAnswer tangent_of(const fast::Pairing& pairing, const Motion& motion, double increment) {
  fast::Workspace workspace;
  return load_tangent(pairing, motion.pose, motion.velocity, load_at(pairing, motion),
                      {increment, increment, increment, increment}, workspace);
}

/// Bubbles that overlap by some 2 cm, turned and moving.
Motion bubbles_motion() {
  Motion motion;
  motion.pose.A = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  motion.pose.r = {0.13, 0.04, 0.12};
  motion.velocity = {{0.002, -0.003, -0.001}, {0.01, 0.02, -0.03}};
  return motion;
}

// |forward quotient - central one| is half of the second difference over the change, whatever the function. The
// second term is rounding: loads are good to eps S/p, and S/p is some 100 here.
TEST(LoadTangent, SlopesAreWithinTheSecondDifferenceOfCentralQuotients) {
  const fast::Surface bubble(generate::bubble());
  const Motion here = bubbles_motion();
  const double h = 1e-6;
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    const fast::Pairing pairing(bubble, bubble, rough(), mode, Scheme::clipped);
    const Load load = load_at(pairing, here);
    ASSERT_GT(load.head<3>().norm(), 10);
    const TangentAnswer answer = tangent_of(pairing, here, h);
    ASSERT_TRUE(answer.exists);
    EXPECT_EQ(answer.whole, 7);
    EXPECT_EQ(answer.law_only, 5);
    EXPECT_EQ(answer.tangent.load, load);
    const double rounding = 1e3 * kEps * load.norm() / h;
    for (int i = 0; i < 12; ++i) {
      const Load ahead = load_at(pairing, displaced(here, i, h)), behind = load_at(pairing, displaced(here, i, -h));
      const Load central = (ahead - behind) / (2 * h);
      const double bound = (ahead - 2 * load + behind).norm() / (2 * h) + rounding;
      EXPECT_LT((answer.tangent.slope.col(i) - central).norm(), bound) << i;
      // A bound that tells the sign and the column.
      EXPECT_LT(bound, 0.01 * central.norm()) << i;
    }
  }
}

TEST(LoadTangent, ReproducesTheLoadsItWasMadeOf) {
  const fast::Surface bubble(generate::bubble());
  const fast::Pairing pairing(bubble, bubble, rough(), Mode::both, Scheme::clipped);
  const Motion here = bubbles_motion();
  const TangentAnswer answer = tangent_of(pairing, here, 1e-5);
  for (int i = 0; i < 12; ++i) {
    const Motion there = displaced(here, i, 1e-5);
    const Load load = load_at(pairing, there);
    // The change itself is rounded: eps, of a rotation matrix, beside 1e-5.
    const double bound = 1e3 * kEps * load.norm() + 10 * kEps * answer.tangent.slope.col(i).norm();
    EXPECT_LT((answer.tangent.at(there.pose, there.velocity) - load).norm(), bound) << i;
  }
}

// A rotation by phi counts as sin(phi).
TEST(LoadTangent, RotationsCountByTheirSine) {
  LoadTangent tangent;
  tangent.slope.setZero();
  tangent.slope.col(4) << 1, 2, 3, 4, 5, 6;
  for (const double phi : {1e-3, 0.1, -0.3}) {
    Pose pose;
    pose.A = Eigen::AngleAxisd(phi, Eigen::Vector3d::UnitY()).toRotationMatrix();
    const double counted = tangent.at(pose, {})[0];
    EXPECT_LE(std::abs(counted - phi), std::pow(std::abs(phi), 3) / 6);
    EXPECT_NEAR(counted, std::sin(phi), 4 * kEps);
  }
}

constexpr double kStiffness = 1e6, kDamping = 2e4, kMu = 0.5, kSlip = 1e-3, kDepth = 1e-3;

ContactLaw rough_floor() {
  ContactLaw law;
  law.stiffness = kStiffness;
  law.damping = kDamping;
  law.friction = kMu;
  law.slip_velocity = kSlip;
  return law;
}

/// A plate as E and on it, 1 mm deep, a block of 0.6 m x 0.4 m, 0.2 m high. The plate carries the elements: tilted, a
/// block that does is also pressed by its sides.
fast::Pairing block_on_plate(const ContactLaw& law) {
  return fast::Pairing(fast::Surface(generate::plate(3, 3, 1)), fast::Surface(generate::box({0.6, 0.4, 0.2})), law,
                       Mode::E, Scheme::clipped);
}

Motion sliding() {
  Motion motion;
  motion.pose.r = {0.03, 0.02, 0.1 - kDepth};
  motion.velocity.v = {0.3 * kSlip, 0, 0};
  return motion;
}

// In closed form, force and torque on the plate. N = c A u presses it down; friction N mu s (2 - s) drags it along.
TEST(LoadTangent, OfABlockOnAPlateAreStiffnessDampingAndTheSlopeOfFriction) {
  const double A = 0.6 * 0.4, N = kStiffness * A * kDepth, I_x = 0.6 * std::pow(0.4, 3) / 12, s = 0.3;
  const TangentAnswer answer = tangent_of(block_on_plate(rough_floor()), sliding(), 1e-8);
  ASSERT_TRUE(answer.exists);
  const auto& slope = answer.tangent.slope;
  EXPECT_NEAR(answer.tangent.load[2], -N, 1e-9 * N);
  EXPECT_NEAR(answer.tangent.load[0], N * kMu * s * (2 - s), 1e-9 * N);
  // Increments are some 1e-8, in m, rad and m/s: 1e-5 of the depth and of v_eps.
  const auto expect_slope = [&](int row, int column, double expected) {
    EXPECT_NEAR(slope(row, column), expected, 1e-4 * std::abs(expected)) << row << ", " << column;
  };
  expect_slope(2, 2, kStiffness * A);                 // lifted: less pressed
  expect_slope(2, 8, kDamping * A);                   // lifting
  expect_slope(0, 6, 2 * N * kMu * (1 - s) / kSlip);  // along the slip
  expect_slope(1, 7, N * kMu * (2 - s) / kSlip);      // across
  // Tilted about x: pressed where y > 0 is less, and the bottom, 0.1 m below Mf, moves along y.
  expect_slope(3, 3, kStiffness * I_x - N * 0.1);
}

/// A cube with its corner 1 cm deep in a plate's lower side, right above the cube's centre: tilting it either way makes
/// the corner less deep, by second order.
Motion corner_from_below() {
  Motion motion;
  motion.pose.A =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::Ones(), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  motion.pose.r = {0.03, 0.02, -1 + 0.01 - 0.1 * std::sqrt(3.0)};
  return motion;
}

TEST(LoadTangent, IsTakenBackwardsWhereThePoseAheadIsTooDeep) {
  const fast::Surface plate(generate::plate(3, 3, 1)), cube(generate::box({0.2, 0.2, 0.2}));
  ContactLaw law = rough_floor();
  const TangentAnswer ahead =
      tangent_of(fast::Pairing(plate, cube, law, Mode::E, Scheme::clipped), corner_from_below(), 1e-6);
  EXPECT_EQ(ahead.whole, 7);
  law.max_penetration = 0.01 * (1 + 1e-7);
  const TangentAnswer behind =
      tangent_of(fast::Pairing(plate, cube, law, Mode::E, Scheme::clipped), corner_from_below(), 1e-6);
  ASSERT_TRUE(behind.exists);
  EXPECT_EQ(behind.whole, 8);
  EXPECT_EQ(behind.law_only, 5);
  // The force grows with the cube of the depth u: the two quotients differ by the increment over u, doubled.
  const double difference = (behind.tangent.slope.col(2) - ahead.tangent.slope.col(2)).norm();
  EXPECT_NEAR(difference, 2e-4 * ahead.tangent.slope.col(2).norm(), 1e-5 * ahead.tangent.slope.col(2).norm());
}

TEST(LoadTangent, IsNotThereWherePosesOnBothSidesAreTooDeep) {
  ContactLaw law = rough_floor();
  law.max_penetration = kDepth * (1 + 1e-7);  // tilted either way, an edge is deeper
  EXPECT_FALSE(tangent_of(block_on_plate(law), sliding(), 1e-6).exists);
}

TEST(LoadTangent, IncrementsAreNotLostInRounding) {
  const fast::Surface bubble(generate::bubble());
  const fast::Pairing pairing(bubble, bubble, rough(), Mode::E, Scheme::clipped);
  const TangentAnswer tiny = tangent_of(pairing, bubbles_motion(), 1e-300);
  const TangentAnswer small = tangent_of(pairing, bubbles_motion(), 1e-7);
  EXPECT_LT((tiny.tangent.slope - small.tangent.slope).norm(), 1e-3 * small.tangent.slope.norm());
}

}  // namespace
}  // namespace pcm::simbody
