// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "compare/bodies/known_answer_bodies.h"
#include "compare/known_answers/dynamic_answer_support.h"
#include "compare/known_answers/dynamic_closed_forms.h"
#include "compare/known_answers/dynamics.h"
#include "compare/known_answers/one_body_motion.h"
#include "meshes/generate/boxes.h"

namespace pcm::compare {

namespace {

using Eigen::Vector3d;

constexpr double kMass = 2, kStiffness = 8e3, kWidth = 0.5, kArea = kWidth * kWidth, kGravity = 9.81;
constexpr double kSpring = kStiffness * kArea;  // N/m

Mode mode_for(Scheme scheme) {
  return scheme == Scheme::clipped ? Mode::both : Mode::F;
}

/// A box that slides along x on a long plate, damped in the normal direction with 0.7 of critical damping.
OneBodyMotion sliding_box(const MovingBody& body, double friction, double slip_velocity, const MotionScale& scale,
                          Scheme scheme, double tolerance) {
  ContactLaw law = stiffness(kStiffness);
  law.damping = 2 * 0.7 * std::sqrt(body.mass * kSpring) / kArea;
  law.friction = friction;
  law.slip_velocity = slip_velocity;
  const fast::Surface plate(generate::plate(4, 2, 1, 16, 8));
  const fast::Surface box(
      generate::box(Vector3d(-kWidth / 2, -kWidth / 2, 0), Vector3d(kWidth / 2, kWidth / 2, kWidth)));
  Pose home;
  home.r = {-1.4, 0.03, 0};
  return {fast::Pairing(plate, box, law, mode_for(scheme), scheme), home, body, scale, tolerance};
}

DynamicAnswer blank(const DynamicPlan& plan, double tolerance) {
  DynamicAnswer answer;
  answer.scheme = plan.scheme;
  answer.mode = mode_for(plan.scheme);
  set_tolerance(answer, tolerance);
  return answer;
}

/// A16: from rest at half the static depth until the speed has been steady for long. Both degrees of freedom are
/// damped: an error made on the way decays. While it does, a relative error of the depth moves the speed, relative to
/// v_eps, by less than half of tan a / mu / (1 - s), s = v / v_eps; relative to s that is tan a / (2 mu s (1 - s)), and
/// an error of the speed itself 1 / s.
DynamicAnswer creep(const DynamicPlan& plan, double tolerance) {
  const double friction = 0.25, slope = 0.2, slip_velocity = 0.1;
  const double angle = std::atan(slope), s = creep_speed(slope, friction);
  const double static_depth = kMass * kGravity * std::cos(angle) / kSpring;
  const double frequency = std::sqrt(kSpring / kMass);
  const MovingBody body{kMass, kGravity * Vector3d(std::sin(angle), 0, -std::cos(angle)), Vector3d(1, 0, 1)};
  const MotionScale scale{Vector3d(static_depth, static_depth, static_depth),
                          Vector3d(slip_velocity, slip_velocity, static_depth * frequency)};
  OneBodyMotion motion = sliding_box(body, friction, slip_velocity, scale, plan.scheme, tolerance);
  // The speed's error decays at the rate 2 mu g cos a (1 - s) / v_eps.
  const double rate = 2 * friction * kGravity * std::cos(angle) * (1 - s) / slip_velocity;
  double effective_steps = 0;
  const MotionState start{0, {0, 0, -static_depth / 2}, Vector3d::Zero()};
  const MotionState steady = motion.settle(start, rate, 40, effective_steps);
  DynamicAnswer answer = blank(plan, tolerance);
  answer.id = "A16";
  answer.quantity = "creep speed / v_eps";
  answer.parameter = "mu = 0.25, tan a = 0.2";
  answer.reference = "1 - sqrt(1 - tan a / mu)";
  answer.computed = steady.v_Me.x() / slip_velocity;
  answer.expected = s;
  const double condition = 1 / s + slope / (2 * friction * s * (1 - s));
  answer.bound = dynamic_bound(tolerance, effective_steps, condition, 1);
  answer.steps = motion.work().steps;
  answer.derivatives = motion.work().derivatives;
  return answer;
}

/// A17: slides at the static depth from v0 to v_eps (an event: friction has a kink in its second derivative there),
/// then on until it is at rest to rounding. Distances and speeds are scaled by the distance d and v0: an error of the
/// distance stays, one dv of the speed makes v dv / (mu g) of it, less than 2 d dv / v0. One of the depth, relative to
/// the static depth, moves the friction for the time 2 / (1.4 w) in which it decays, so the speed by mu g dx / (0.7 w).
DynamicAnswer stop(const DynamicPlan& plan, double tolerance) {
  const double friction = 0.3, slip_velocity = 0.5, speed = 2;
  const double static_depth = kMass * kGravity / kSpring, frequency = std::sqrt(kSpring / kMass);
  const double distance = stopping_distance(speed, friction, slip_velocity, kGravity);
  const MovingBody body{kMass, {0, 0, -kGravity}, Vector3d(1, 0, 1)};
  const MotionScale scale{Vector3d(distance, distance, static_depth), Vector3d(speed, speed, static_depth * frequency)};
  OneBodyMotion motion = sliding_box(body, friction, slip_velocity, scale, plan.scheme, tolerance);
  MotionState state = motion.slide({0, {0, 0, -static_depth}, {speed, 0, 0}}, 10, slip_velocity);
  // What is left of the speed decays at the rate 2 mu g / v_eps.
  state = motion.slide(state, state.t + 40 * slip_velocity / (2 * friction * kGravity));
  DynamicAnswer answer = blank(plan, tolerance);
  answer.id = "A17";
  answer.quantity = "stopping distance";
  answer.parameter = "mu = 0.3, v0 = 4 v_eps";
  answer.reference = "v0^2 / (2 mu g) + v_eps^2 / (mu g) (ln 2 - 1/2)";
  answer.computed = state.x_Me.x();
  answer.expected = distance;
  const double condition = 3 + 2 * friction * kGravity / (0.7 * frequency * speed);
  answer.bound = dynamic_bound(tolerance, static_cast<double>(motion.work().steps), condition, 1);
  answer.steps = motion.work().steps;
  answer.derivatives = motion.work().derivatives;
  return answer;
}

}  // namespace

std::vector<DynamicAnswer> frictional_slides(const DynamicPlan& plan) {
  std::vector<DynamicAnswer> answers;
  for (const double tolerance : plan.tolerances) answers.push_back(creep(plan, tolerance));
  for (const double tolerance : plan.tolerances) answers.push_back(stop(plan, tolerance));
  return answers;
}

}  // namespace pcm::compare
