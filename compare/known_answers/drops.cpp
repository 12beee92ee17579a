// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "compare/bodies/known_answer_bodies.h"
#include "compare/known_answers/dynamic_answer_support.h"
#include "compare/known_answers/dynamic_closed_forms.h"
#include "compare/known_answers/dynamics.h"
#include "compare/known_answers/one_body_motion.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/round.h"

namespace pcm::compare {

namespace {

using Eigen::Vector3d;

constexpr double kMass = 2, kRadius = 0.2, kStiffness = 1.17857e6, kSpeed = 4.42945, kGravity = 9.81;
constexpr double kSphere = std::numbers::pi * kStiffness * kRadius;  // F = kSphere h^2 (A2)

/// Turned so that no vertex, edge or face is at the bottom.
TriangleMesh turned_sphere(Index level) {
  return turned(generate::icosphere(kRadius, level), fixed_rotation(0));
}

/// How far the polyhedron's faces are inside the sphere at most.
double greatest_gap(const TriangleMesh& mesh) {
  double least = kRadius;
  for (const Triangle& t : mesh.faces) {
    const Vector3d &p = mesh.vertices[t[0]], &q = mesh.vertices[t[1]], &s = mesh.vertices[t[2]];
    least = std::min(least, p.dot((q - p).cross(s - p).normalized()));
  }
  return kRadius - least;
}

fast::Pairing sphere_on_plate(const TriangleMesh& sphere, const ContactLaw& law, Scheme scheme) {
  return {fast::Surface(generate::plate(2, 2, 1)), fast::Surface(sphere), law, Mode::F, scheme};
}

/// The sphere's centre a radius above the plate: the smooth sphere touches there, the polyhedron not yet.
Pose home() {
  Pose pose;
  pose.r = {0.013, 0.007, kRadius};
  return pose;
}

/// The depth at rest of the smooth sphere.
double smooth_rest() {
  return std::sqrt(kMass * kGravity / kSphere);
}

/// The drop as the engine has it, from home with the full speed.
Drop engine_drop(const TriangleMesh& sphere, Scheme scheme, double gravity, double tolerance, IntegrationWork& work,
                 double& energy_kept) {
  const Drop smooth = quadratic_drop(kSphere, {kMass, kSpeed, gravity});
  const MovingBody body{kMass, {0, 0, -gravity}, Vector3d::UnitZ()};
  const MotionScale scale{Vector3d::Constant(smooth.depth), Vector3d::Constant(kSpeed)};
  OneBodyMotion motion(sphere_on_plate(sphere, stiffness(kStiffness), scheme), home(), body, scale, tolerance);
  const Bounce bounce = motion.bounce({0, Vector3d::Zero(), {0, 0, -kSpeed}});
  work = motion.work();
  energy_kept = std::pow(bounce.end.v_Me.z() / kSpeed, 2);
  return {-bounce.deepest.x_Me.z(), bounce.end.t, bounce.deepest_force};
}

/// With x, v scaled by depth and speed, v^2 / 2 + w(x) is kept. An error dx, dv at an earlier time moves the greatest
/// depth by (v dv + f dx) / f_max, f_max = F h / (m v0^2), which is 3/2 for W ~ h^3 and at least 1 for any force that
/// rises from 0 (the work is less than the greatest force times the way): dh / h <= 2. Force follows with the slope
/// d ln F / d ln h, 2 for the sphere and less than 5/2 for the polyhedra here, whose contact begins a little later: 5.
/// The energy moves by 2 (dv + f_max dx): 5. The time, taken between the passages through home,
/// moves by dx / v0 and by what it depends on the energy, T ~ v0^(-1/3), times 2 (dv + f_max dx): less than 4.
constexpr double kDepthCondition = 2, kForceCondition = 5, kEnergyCondition = 5, kTimeCondition = 4;

double drop_bound(double condition, double tolerance, double steps) {
  return dynamic_bound(tolerance, steps, condition, kRadius / smooth_rest());
}

/// Damped so that the smooth sphere would settle with 0.7 of critical damping were it not for the fade, which is there
/// because an element born with a velocity would make the force jump.
ContactLaw settling_law() {
  const double h = smooth_rest(), patch = 2 * std::numbers::pi * kRadius * h;
  ContactLaw law = stiffness(kStiffness);
  law.damping = 2 * 0.7 * std::sqrt(2 * kSphere * h * kMass) / patch;
  law.transition_depth = h;
  return law;
}

struct EngineRest {
  double depth = 0;
  double effective_steps = 0;
  IntegrationWork work;
};

/// The engine's sphere at rest, having settled from half its depth. Near rest the fade halves the damping: errors decay
/// as exp(-0.35 w t) there, w the frequency without damping.
EngineRest engine_rest(const TriangleMesh& sphere, Scheme scheme, double tolerance) {
  const double h = smooth_rest(), frequency = std::sqrt(2 * kSphere * h / kMass);
  const MovingBody body{kMass, {0, 0, -kGravity}, Vector3d::UnitZ()};
  const MotionScale scale{Vector3d::Constant(h), Vector3d::Constant(h * frequency)};
  OneBodyMotion motion(sphere_on_plate(sphere, settling_law(), scheme), home(), body, scale, tolerance);
  EngineRest rest;
  const MotionState start{0, {0, 0, -h / 2}, Vector3d::Zero()};
  rest.depth = -motion.settle(start, 0.35 * frequency, 40, rest.effective_steps).x_Me.z();
  rest.work = motion.work();
  return rest;
}

/// As for the damped bounce, sqrt((1 + z) / (1 - z)) with z = 0.35.
constexpr double kRestCondition = 1.5;

DynamicAnswer blank(const char* id, Scheme scheme, double tolerance) {
  DynamicAnswer answer;
  answer.id = id;
  answer.scheme = scheme;
  answer.mode = Mode::F;
  set_tolerance(answer, tolerance);
  return answer;
}

/// A level of refinement in the clipped scheme.
DynamicAnswer refined(const char* id, const TriangleMesh& sphere, double tolerance) {
  DynamicAnswer answer = blank(id, Scheme::clipped, tolerance);
  answer.reference = "smooth sphere";
  answer.level = fmt::format("icosphere of {} faces", sphere.faces.size());
  answer.resolution = mean_edge(sphere);
  answer.second_order = true;
  return answer;
}

/// Bound of |x / expected - 1| for x between low and high.
double half_width(double low, double high, double expected) {
  return std::max(std::abs(low / expected - 1), std::abs(high / expected - 1));
}

}  // namespace

std::vector<DynamicAnswer> sphere_drops(const DynamicPlan& plan) {
  std::vector<DynamicAnswer> answers;
  const TriangleMesh sphere = turned_sphere(plan.sphere_level);
  const PolyhedralFoundation foundation(sphere, kStiffness, plan.scheme);
  const double touching = -kRadius, centre = 0;  // heights of the plane in the sphere's frame
  const std::string faces = fmt::format("{} faces", sphere.faces.size());
  for (const double gravity : {0.0, kGravity}) {
    const Drop expected = polyhedral_drop(foundation, touching, centre, {kMass, kSpeed, gravity});
    for (const double tolerance : plan.tolerances) {
      IntegrationWork work;
      double energy = 0;
      const Drop drop = engine_drop(sphere, plan.scheme, gravity, tolerance, work, energy);
      DynamicAnswer answer = blank("A14", plan.scheme, tolerance);
      answer.parameter = "g = " + number(gravity) + ", " + faces;
      answer.reference = "the polyhedron's energy";
      const auto add = [&](const char* quantity, double computed, double reference, double condition) {
        answer.quantity = quantity;
        append(answer, computed, reference, drop_bound(condition, tolerance, static_cast<double>(work.steps)), work,
               answers);
      };
      add("greatest depth", drop.depth, expected.depth, kDepthCondition);
      add("contact time", drop.contact_time, expected.contact_time, kTimeCondition);
      add("greatest force", drop.force, expected.force, kForceCondition);
      add("energy kept", energy, 1, kEnergyCondition);
    }
  }
  const double expected = polyhedral_rest(foundation, touching, centre, kMass * kGravity) - touching;
  for (const double tolerance : plan.tolerances) {
    const EngineRest rest = engine_rest(sphere, plan.scheme, tolerance);
    DynamicAnswer answer = blank("A15", plan.scheme, tolerance);
    answer.quantity = "depth at rest";
    answer.parameter = faces;
    answer.reference = "weight on the polyhedron";
    append(answer, rest.depth, expected, drop_bound(kRestCondition, tolerance, rest.effective_steps), rest.work,
           answers);
  }
  return answers;
}

std::vector<DynamicAnswer> sphere_geometry(const std::vector<Index>& levels, double tolerance) {
  std::vector<DynamicAnswer> drops, rests;
  for (const Index level : levels) {
    const TriangleMesh sphere = turned_sphere(level);
    const double s = greatest_gap(sphere);
    // Force between that of a sphere of radius r - s sunk by h - s, and r^2 / (r - s) of that of the sphere.
    const double soft = kSphere * (1 - s / kRadius), stiff = kSphere / (1 - s / kRadius);
    for (const double gravity : {0.0, kGravity}) {
      const Dropped body{kMass, kSpeed, gravity};
      const Drop smooth = quadratic_drop(kSphere, body);
      const double least = quadratic_drop(stiff, body).depth;
      // The softer sphere falls by s before it touches.
      const Dropped later{kMass, std::sqrt(kSpeed * kSpeed + 2 * gravity * s), gravity};
      const double greatest = quadratic_drop(soft, later).depth + s;
      IntegrationWork work;
      double energy = 0;
      const Drop drop = engine_drop(sphere, Scheme::clipped, gravity, tolerance, work, energy);
      DynamicAnswer answer = refined("A14", sphere, tolerance);
      answer.parameter = "g = " + number(gravity);
      const auto add = [&](const char* quantity, double computed, double expected, double geometry, double condition) {
        answer.quantity = quantity;
        // The error of the greatest force is far below its terms' (a softer body sinks deeper): no order to rely on.
        answer.second_order = answer.quantity != "greatest force";
        append(answer, computed, expected, geometry + drop_bound(condition, tolerance, static_cast<double>(work.steps)),
               work, drops);
      };
      add("greatest depth", drop.depth, smooth.depth, half_width(least, greatest, smooth.depth), kDepthCondition);
      add("contact time", drop.contact_time, smooth.contact_time, std::numeric_limits<double>::infinity(),
          kTimeCondition);
      add("greatest force", drop.force, smooth.force,
          half_width(soft * std::pow(least - s, 2), stiff * greatest * greatest, smooth.force), kForceCondition);
    }
    const EngineRest rest = engine_rest(sphere, Scheme::clipped, tolerance);
    const double h = smooth_rest(), weight = kMass * kGravity;
    DynamicAnswer answer = refined("A15", sphere, tolerance);
    answer.quantity = "depth at rest";
    const double geometry = half_width(std::sqrt(weight / stiff), std::sqrt(weight / soft) + s, h);
    append(answer, rest.depth, h, geometry + drop_bound(kRestCondition, tolerance, rest.effective_steps), rest.work,
           rests);
  }
  drops.insert(drops.end(), rests.begin(), rests.end());
  return drops;
}

}  // namespace pcm::compare
