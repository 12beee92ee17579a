// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/bodies/known_answer_bodies.h"
#include "compare/known_answers/dynamic_answer_support.h"
#include "compare/known_answers/dynamic_closed_forms.h"
#include "compare/known_answers/dynamics.h"
#include "compare/known_answers/one_body_motion.h"
#include "meshes/generate/boxes.h"

namespace pcm::compare {

namespace {

using Eigen::Vector3d;

/// A box of the mass m falls with v0 on a plate from a small height, without gravity.
constexpr double kMass = 2, kStiffness = 1e5, kSpeed = 1, kWidth = 0.5, kArea = kWidth * kWidth;

struct BoxBounce {
  ContactLaw law;
  Scheme scheme;
  double tolerance;
};

/// Restitution of the bounce, as the engine has it.
double restitution(const BoxBounce& drop, IntegrationWork& work) {
  const double depth = kSpeed * std::sqrt(kMass / (kStiffness * kArea));
  const fast::Surface plate(generate::plate(2, 2, 1, 8, 8));
  const fast::Surface box(
      generate::box(Vector3d(-kWidth / 2, -kWidth / 2, 0), Vector3d(kWidth / 2, kWidth / 2, kWidth)));
  const fast::Pairing pairing(plate, box, drop.law, Mode::both, drop.scheme);
  const MovingBody body{kMass, Vector3d::Zero(), Vector3d::UnitZ()};
  const MotionScale scale{Vector3d::Constant(depth), Vector3d::Constant(kSpeed)};
  OneBodyMotion motion(pairing, Pose{}, body, scale, drop.tolerance);
  const Bounce bounce = motion.bounce({0, {0, 0, depth / 2}, {0, 0, -kSpeed}});
  work = motion.work();
  return bounce.end.v_Me.z() / kSpeed;
}

/// Scaled by depth and speed, q = x^2 + 2 z x v + v^2 decays as exp(-2 z t), and it lies between (1 - z) and (1 + z)
/// times x^2 + v^2: an error grows by sqrt((1 + z) / (1 - z)) at most. At separation a depth off by dx moves the speed
/// by the acceleration times dx / v, 2 z dx; where the force ends by itself there is none.
double damped_condition(double z, double e) {
  return (1 + 2 * z) * std::sqrt((1 + z) / (1 - z)) / e;
}

/// With x, v scaled by depth and speed, a^2 x^2 / 2 + a v - ln(1 + a v) is kept. At the end, where v = -e, a change dx,
/// dv at an earlier time arrives as de = (1 - a e) / e x dx + (v / e) (1 - a e) / (1 + a v) dv. x <= 1 bounds the
/// first factor by (1 - a e) / e. The second is greatest at the ends of -e <= v <= 1: there it is -1, and
/// (1 - a e) / (e (1 + a)) < 1.
double faded_condition(double a, double e) {
  return (1 + (1 - a * e) / e) / e;
}

/// One row a tolerance.
void add_bounces(const DynamicPlan& plan, DynamicAnswer answer, const ContactLaw& law, double expected,
                 double condition, std::vector<DynamicAnswer>& answers) {
  answer.quantity = "restitution";
  answer.scheme = plan.scheme;
  for (const double tolerance : plan.tolerances) {
    set_tolerance(answer, tolerance);
    IntegrationWork work;
    const double computed = restitution({law, plan.scheme, tolerance}, work);
    const double bound = dynamic_bound(tolerance, static_cast<double>(work.steps), condition, 1);
    append(answer, computed, expected, bound, work, answers);
  }
}

}  // namespace

std::vector<DynamicAnswer> flat_bounces(const DynamicPlan& plan) {
  std::vector<DynamicAnswer> answers;
  DynamicAnswer answer;
  answer.id = "A12";
  answer.reference = "closed form of the damped oscillator";
  const std::pair<DampingMode, const char*> modes[] = {{DampingMode::full, "full damping"},
                                                       {DampingMode::no_tension, "no tension"},
                                                       {DampingMode::compression, "compression only"}};
  for (const double z : {0.1, 0.2, 0.3, 0.5}) {
    for (const auto& [mode, name] : modes) {
      answer.parameter = "z = " + number(z) + ", " + name;
      ContactLaw law = stiffness(kStiffness);
      law.damping = 2 * z * std::sqrt(kMass * kStiffness * kArea) / kArea;
      law.damping_mode = mode;
      const double e = flat_restitution(z, mode);
      add_bounces(plan, answer, law, e, damped_condition(z, e), answers);
    }
  }
  answer.id = "A13";
  answer.reference = "a - ln(1 + a) = -a e - ln(1 - a e)";
  for (const double a : {0.1, 0.3, 1.0, 3.0}) {
    answer.parameter = "a = " + number(a);
    ContactLaw law = stiffness(kStiffness);
    law.transition_depth = 0.05;  // five times the depth without damping
    law.damping = a * kStiffness * law.transition_depth / kSpeed;
    const double e = faded_restitution(a);
    add_bounces(plan, answer, law, e, faded_condition(a, e), answers);
  }
  return answers;
}

}  // namespace pcm::compare
