// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A ball that rolls on a plate, through the whole path: scene file, Simbody's model, contact, integrator.
//
// Forces act in the plate's plane (its layer is a million times as stiff as the ball's, (13)), in which all points of
// the ball slip alike, with w = v - r omega, r the height of the ball's centre above the plane. With k = I / (m r^2),
// whatever the friction, v + k r omega changes by what gravity alone gives, and so
//   v = (v + k r omega + k w) / (1 + k).
#include <cmath>
#include <cstdio>

#include "tests/simulate/run/run_scene.h"

namespace pcm::simulate::rolling_test {
namespace {

class Rolling : public KnownMotion {};
INSTANTIATE_TEST_SUITE_P(Methods, Rolling, kEachMethodOfHigherOrder, method_name);

constexpr double kRadius = 0.1, kStiffness = 1.3e6, kGravity = 9.81, kSlipVelocity = 1e-2;
constexpr double kSpecificInertia = 0.4 * kRadius * kRadius;  // of a ball of 1 kg, m^2

/// How deep a ball of 1 kg lies: c times the cap's volume carries it.
double depth(double weight) {
  double u = 0;
  for (int i = 0; i < 50; ++i) u = std::sqrt(weight / kStiffness / std::acos(-1.0) / (kRadius - u / 3));
  return u;
}

std::string ball_on_plate(double tilt, double friction, double velocity, double duration) {
  const double g_x = kGravity * std::sin(tilt), g_z = kGravity * std::cos(tilt);
  return R"({"laws": {"law": {"layers": [1e12, 1.3e6], "slip_velocity": 1e-2, "friction": )" +
         std::to_string(friction) + R"(}},
    "ground": {"surfaces": [{"name": "plate", "make": "plate", "parameters": {"extent_x": 4, "extent_y": 3, "thickness": 2}}]},
    "bodies": [{"name": "ball", "mass": 1, "centre_of_mass": [0, 0, 0], "inertia": [4e-3, 4e-3, 4e-3],
      "at": {"position": [0.01, 0.02, )" +
         std::to_string(kRadius - depth(g_z)) + R"(], "rotation": {"axis": [1, 2, 3], "angle": 1}},
      "velocity": [)" +
         std::to_string(velocity) + R"(, 0, 0],
      "surfaces": [{"name": "ball", "make": "icosphere", "parameters": {"radius": 0.1, "level": 4}}]}],
    "pairings": [{"E": "plate", "F": "ball", "law": "law", "mode": "E", "scheme": "clipped"}],
    "gravity": [)" +
         std::to_string(g_x) + ", 0, " + std::to_string(-g_z) + R"(],
    "duration": )" +
         std::to_string(duration) + R"(, "integrator": {"greatest_step": 0.005}})";
}

/// The greatest distance of the icosphere's faces from its sphere: 5,120 faces of nearly equal sides a, whose centres
/// lie a^2 / (6 R) below it. The largest sides are 1.2 times the mean.
double sagitta() {
  const double face = 4 * std::acos(-1.0) * kRadius * kRadius / 5120;
  return 1.44 * 4 / std::sqrt(3) * face / (6 * kRadius);
}

// A ball of faces is not round. It lies deeper or less deep by a sagitta, which changes r, and where it lands less deep
// it hops by as much; and from face to face it climbs m g times a sagitta at most, against a kinetic energy of m v^2 /
// 2 and more. Both parts of v are first-order:
double relative_error_of_faces(double g_z, double v) {
  return 2 * sagitta() / kRadius + g_z * sagitta() / (v * v);
}

// Friction mu m g brakes it while it slips faster than v_eps, w falling at A = mu g (1 + 1 / k); from then on by (20),
// w' = -A s (2 - s) with s = w / v_eps, which adds v_eps^2 ln 2 / A to the path of w. What is left is v0 / (1 + k): 5/7
// of v0, were it not for the depth.
TEST_P(Rolling, OfABallThatSlidesFirstEndsAtFiveSevenths) {
  constexpr double kFriction = 0.3, kVelocity = 1, kEnd = 0.25;
  const double r = kRadius - depth(kGravity), k = kSpecificInertia / (r * r);
  const double slowing = kFriction * kGravity * (1 + 1 / k);
  ASSERT_LT(kVelocity / slowing, 0.5 * kEnd);
  const double v = kVelocity / (1 + k);
  const double slid =
      ((kVelocity * kVelocity - kSlipVelocity * kSlipVelocity) / 2 + kSlipVelocity * kSlipVelocity * std::log(2)) /
      slowing;
  const Eigen::VectorXd y = end_of(scene_with(ball_on_plate(0, kFriction, kVelocity, kEnd), GetParam(), 1e-6));
  const double bound = relative_error_of_faces(kGravity, v);
  std::printf("v %.6f, expected %.6f; r omega %.6f; x %.6f, expected %.6f; bound %.3g\n", y[kVx], v, r * y[kWy],
              y[kX] - 0.01, v * kEnd + k / (1 + k) * slid, bound);
  EXPECT_NEAR(y[kVx], v, bound * v);
  EXPECT_NEAR(r * y[kWy], v, bound * v);
  EXPECT_NEAR(y[kX] - 0.01, v * kEnd + k / (1 + k) * slid, bound * v * kEnd);
}

// Down a slope from rest: v + k r omega = g sin(tilt) t, and friction turns the ball at the slip w at which (20) gives
// m g sin(tilt) k / (1 + k); w is there from the first milliseconds on, v_eps / (2 mu g cos(tilt)).
TEST_P(Rolling, OfABallDownASlopeIsSlowedByItsInertia) {
  constexpr double kTilt = 0.2, kFriction = 0.4, kEnd = 0.5;
  const double along = kGravity * std::sin(kTilt), normal = kGravity * std::cos(kTilt);
  const double r = kRadius - depth(normal), k = kSpecificInertia / (r * r);
  const double share = along * k / (1 + k) / (kFriction * normal);
  ASSERT_LT(share, 1);
  const double slip = kSlipVelocity * (1 - std::sqrt(1 - share));
  const Eigen::VectorXd y = end_of(scene_with(ball_on_plate(kTilt, kFriction, 0, kEnd), GetParam(), 1e-6));
  const double v = (along * kEnd + k * slip) / (1 + k);
  const double x = (along * kEnd * kEnd / 2 + k * slip * kEnd) / (1 + k);
  const double bound = relative_error_of_faces(normal, v);
  std::printf("v %.6f, expected %.6f; slip %.6f, expected %.6f; x %.6f, expected %.6f; bound %.3g\n", y[kVx], v,
              y[kVx] - r * y[kWy], slip, y[kX] - 0.01, x, bound);
  EXPECT_NEAR(y[kVx], v, bound * v);
  EXPECT_NEAR(y[kX] - 0.01, x, bound * x);
  EXPECT_NEAR(r * y[kWy], v - slip, bound * v);
}

}  // namespace
}  // namespace pcm::simulate::rolling_test
