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

LoadTangent tangent_of(const fast::Pairing& pairing, const Motion& motion) {
  fast::Workspace workspace;
  return load_tangent(pairing, motion.pose, motion.velocity, workspace);
}

/// Bubbles that overlap by some 2 cm, turned and moving.
Motion bubbles_motion() {
  Motion motion;
  motion.pose.A = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  motion.pose.r = {0.13, 0.04, 0.12};
  motion.velocity = {{0.002, -0.003, -0.001}, {0.01, 0.02, -0.03}};
  return motion;
}

// A central quotient is off by a sixth of the third derivative times the change squared, of which the difference to the
// quotient over the double change is thrice as much. The second term is rounding: loads are good to eps S/p, and S/p is
// some 100 here.
TEST(LoadTangent, SlopesAreThoseOfCentralQuotients) {
  const fast::Surface bubble(generate::bubble());
  const Motion here = bubbles_motion();
  const double h = 1e-6;
  for (const Mode mode : {Mode::E, Mode::F, Mode::both}) {
    const fast::Pairing pairing(bubble, bubble, rough(), mode, Scheme::clipped);
    const Load load = load_at(pairing, here);
    ASSERT_GT(load.head<3>().norm(), 10);
    const LoadTangent tangent = tangent_of(pairing, here);
    EXPECT_EQ(tangent.load, load);
    const double rounding = 1e3 * kEps * load.norm() / h;
    for (int i = 0; i < 12; ++i) {
      const auto central = [&](double change) -> Load {
        return (load_at(pairing, displaced(here, i, change)) - load_at(pairing, displaced(here, i, -change))) /
               (2 * change);
      };
      const Load quotient = central(h);
      const double bound = (quotient - central(2 * h)).norm() + rounding;
      EXPECT_LT((tangent.slope.col(i) - quotient).norm(), bound) << i;
      // A bound that tells the sign and the column.
      EXPECT_LT(bound, 0.01 * quotient.norm()) << i;
    }
  }
}

// By half of the second difference.
TEST(LoadTangent, IsTheLoadNearByToSecondOrder) {
  const fast::Surface bubble(generate::bubble());
  const fast::Pairing pairing(bubble, bubble, rough(), Mode::both, Scheme::clipped);
  const Motion here = bubbles_motion();
  const LoadTangent tangent = tangent_of(pairing, here);
  const double h = 1e-5;
  for (int i = 0; i < 12; ++i) {
    const Motion there = displaced(here, i, h);
    const Load ahead = load_at(pairing, there), behind = load_at(pairing, displaced(here, i, -h));
    const double bound = (ahead - 2 * tangent.load + behind).norm() + 1e3 * kEps * tangent.load.norm();
    EXPECT_LT((tangent.at(there.pose, there.velocity) - ahead).norm(), bound) << i;
    EXPECT_LT(bound, 0.05 * (ahead - behind).norm()) << i;
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
  const LoadTangent tangent = tangent_of(block_on_plate(rough_floor()), sliding());
  const auto& slope = tangent.slope;
  EXPECT_NEAR(tangent.load[2], -N, 1e-9 * N);
  EXPECT_NEAR(tangent.load[0], N * kMu * s * (2 - s), 1e-9 * N);
  // The depth, a difference of lengths a thousand times as great, is good to 1e-13.
  const auto expect_slope = [&](int row, int column, double expected) {
    EXPECT_NEAR(slope(row, column), expected, 1e-11 * std::abs(expected)) << row << ", " << column;
  };
  expect_slope(2, 2, kStiffness * A);                 // lifted: less pressed
  expect_slope(2, 8, kDamping * A);                   // lifting
  expect_slope(0, 6, 2 * N * kMu * (1 - s) / kSlip);  // along the slip
  expect_slope(1, 7, N * kMu * (2 - s) / kSlip);      // across
  // Tilted about x: pressed where y > 0 is less, and the bottom, 0.1 m below Mf, moves along y.
  expect_slope(3, 3, kStiffness * I_x - N * 0.1);
}

}  // namespace
}  // namespace pcm::simbody
