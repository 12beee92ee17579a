// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/one_body_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "meshes/generate/boxes.h"

namespace pcm::compare {
namespace {

using Eigen::Vector3d;

Eigen::VectorXd vector(double a, double b) {
  return Eigen::Vector2d(a, b);
}

TEST(InitialValueProblem, EventsAreFoundWhereTheyRiseAndInTheirOrder) {
  InitialValueProblem circle;
  circle.derivative = [](double, const Eigen::VectorXd& y) { return vector(y[1], -y[0]); };
  circle.events = {[](double, const Eigen::VectorXd& y) { return y[0]; },
                   [](double, const Eigen::VectorXd& y) { return -y[1]; }};
  double t = 0;
  Eigen::VectorXd y = vector(-0.5, std::sqrt(0.75));
  IntegrationWork work;
  const StepTolerance tolerance{1e-11, vector(1e-11, 1e-11)};
  EXPECT_EQ(integrate(circle, tolerance, 100, t, y, work), 0);
  EXPECT_NEAR(t, std::numbers::pi / 6, 1e-9);
  EXPECT_EQ(integrate(circle, tolerance, 100, t, y, work), 1);
  EXPECT_NEAR(t, std::numbers::pi / 6 + std::numbers::pi / 2, 1e-9);
  EXPECT_NEAR(y[0], 1, 1e-9);
  circle.events.clear();
  EXPECT_EQ(integrate(circle, tolerance, 3, t, y, work), std::nullopt);
  EXPECT_EQ(t, 3);
  EXPECT_GT(work.steps, 0);
  EXPECT_GE(work.derivatives, work.steps);
}

TEST(InitialValueProblem, ExceptionsOfTheDerivativeComeOutAgain) {
  InitialValueProblem problem;
  problem.derivative = [](double, const Eigen::VectorXd&) -> Eigen::VectorXd { throw std::domain_error("here"); };
  double t = 0;
  Eigen::VectorXd y = vector(0, 0);
  IntegrationWork work;
  EXPECT_THROW(integrate(problem, {1e-6, vector(1, 1)}, 1, t, y, work), std::domain_error);
}

fast::Pairing box_on_plate(const ContactLaw& law) {
  return {fast::Surface(generate::plate(4, 4, 1)), fast::Surface(generate::box({-0.5, -0.5, 0}, {0.5, 0.5, 1})), law,
          Mode::F};
}

TEST(OneBodyMotion, UndampedBounceTakesHalfAPeriodBetweenTheFlights) {
  ContactLaw law;
  law.stiffness = 200;  // on 1 m^2 with 2 kg: 10 rad/s
  const MotionScale scale{Vector3d::Constant(0.1), Vector3d::Ones()};
  OneBodyMotion motion(box_on_plate(law), Pose{}, {2, Vector3d::Zero(), Vector3d::UnitZ()}, scale, 1e-12);
  const Bounce bounce = motion.bounce({0, {0, 0, 0.25}, {0, 0, -1}});
  EXPECT_NEAR(bounce.touch.t, 0.25, 1e-12);
  EXPECT_NEAR(bounce.deepest.t, 0.25 + 0.05 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(bounce.deepest.x_Me.z(), -0.1, 1e-9);
  EXPECT_NEAR(bounce.deepest_force, 20, 1e-7);
  EXPECT_NEAR(bounce.force_ends.t, 0.25 + 0.1 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(bounce.end.t, 0.5 + 0.1 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(bounce.end.v_Me.z(), 1, 1e-9);
}

TEST(OneBodyMotion, WithoutTensionTheForceEndsBeforeTheBodiesSeparate) {
  ContactLaw law;
  law.stiffness = 200;
  law.damping = 20;  // half of critical
  const MotionScale scale{Vector3d::Constant(0.1), Vector3d::Ones()};
  OneBodyMotion motion(box_on_plate(law), Pose{}, {2, Vector3d::Zero(), Vector3d::UnitZ()}, scale, 1e-10);
  const Bounce bounce = motion.bounce({0, {0, 0, 0.25}, {0, 0, -1}});
  const Vector3d& x = bounce.force_ends.x_Me;
  const Vector3d& v = bounce.force_ends.v_Me;
  EXPECT_LT(x.z(), -0.01);
  EXPECT_NEAR(-law.stiffness * x.z(), law.damping * v.z(), 1e-7);
  EXPECT_EQ(bounce.end.v_Me.z(), v.z());
}

TEST(OneBodyMotion, BodyThatStaysDownIsReported) {
  ContactLaw law;
  law.stiffness = 200;
  law.damping = 1000;
  law.damping_mode = DampingMode::full;
  const MotionScale scale{Vector3d::Constant(0.1), Vector3d::Ones()};
  OneBodyMotion motion(box_on_plate(law), Pose{}, {2, {0, 0, -9.81}, Vector3d::UnitZ()}, scale, 1e-6);
  EXPECT_THROW(motion.bounce({0, {0, 0, 0.1}, {0, 0, 0}}), std::runtime_error);
}

}  // namespace
}  // namespace pcm::compare
