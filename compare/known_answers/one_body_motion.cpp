// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/one_body_motion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcm::compare {

namespace {

using Eigen::Vector3d;

fast::Pairing with_full_damping(const fast::Pairing& pairing) {
  ContactLaw law = pairing.law();
  law.damping_mode = DampingMode::full;
  return {pairing.surface_E(), pairing.surface_F(), law, pairing.mode(), pairing.scheme()};
}

double highest(const TriangleMesh& mesh) {
  double z = mesh.vertices.front().z();
  for (const Vector3d& x : mesh.vertices) z = std::max(z, x.z());
  return z;
}

double lowest(const TriangleMesh& mesh, const Pose& pose) {
  double z = (pose.A * mesh.vertices.front() + pose.r).z();
  for (const Vector3d& x : mesh.vertices) z = std::min(z, (pose.A * x + pose.r).z());
  return z;
}

Eigen::VectorXd stacked(const Vector3d& x, const Vector3d& v) {
  Eigen::VectorXd y(6);
  y << x, v;
  return y;
}

}  // namespace

OneBodyMotion::OneBodyMotion(const fast::Pairing& pairing, const Pose& home, const MovingBody& body,
                             const MotionScale& scale, double relative)
    : pairing_(pairing),
      without_switches_(with_full_damping(pairing)),
      home_(home),
      body_(body),
      scale_(scale),
      tolerance_{relative, relative * stacked(scale.length_Me, scale.velocity_Me)} {
  depth_at_home_ = highest(pairing.surface_E().mesh()) - lowest(pairing.surface_F().mesh(), home);
  // Far above the rounding of positions, far below any depth of interest: the force at twice that depth is negligible.
  least_depth_ = 0x1p-38 * scale.length_Me.z();
}

Vector3d OneBodyMotion::force_by(const fast::Pairing& pairing, const Vector3d& x_Me, const Vector3d& v_Me) {
  Pose pose = home_;
  pose.r += x_Me;
  Wanted only_force;
  only_force.polygons = only_force.areas = only_force.elements = false;
  return -fast::evaluate(pairing, pose, Velocity{v_Me, Vector3d::Zero()}, only_force, workspace_).force_Me;
}

Vector3d OneBodyMotion::contact_force(const Vector3d& x_Me, const Vector3d& v_Me) {
  return force_by(pairing_, x_Me, v_Me);
}

Vector3d OneBodyMotion::reflected(const Force& force, const Vector3d& x_Me, const Vector3d& v_Me) const {
  if (depth(x_Me) >= least_depth_) return force(x_Me, v_Me);
  const Vector3d at_least(x_Me.x(), x_Me.y(), depth_at_home_ - least_depth_);
  const Vector3d mirror = 2 * at_least - x_Me;
  return 2 * force(at_least, v_Me) - force({x_Me.x(), x_Me.y(), mirror.z()}, v_Me);
}

std::optional<std::size_t> OneBodyMotion::advance(const Force& force, const std::vector<Event>& events, double t_end,
                                                  MotionState& state) {
  InitialValueProblem problem;
  problem.derivative = [&](double, const Eigen::VectorXd& y) {
    const Vector3d x = y.head<3>(), v = y.tail<3>();
    const Vector3d acceleration = body_.gravity_Me + force(x, v) / body_.mass;
    return stacked(v, body_.freedom_Me.cwiseProduct(acceleration));
  };
  for (const Event& event : events) {
    problem.events.emplace_back([&event](double, const Eigen::VectorXd& y) { return event(y.head<3>(), y.tail<3>()); });
  }
  Eigen::VectorXd y = stacked(state.x_Me, state.v_Me);
  const auto happened = integrate(problem, tolerance_, t_end, state.t, y, work_);
  state.x_Me = y.head<3>();
  state.v_Me = y.tail<3>();
  return happened;
}

void OneBodyMotion::advance_to(const Force& force, const std::vector<Event>& events, MotionState& state) {
  constexpr double kPatience = 1e3;  // in times the body needs for its scale of length
  const double patience = kPatience * scale_.length_Me.z() / scale_.velocity_Me.z();
  if (!advance(force, events, state.t + patience, state)) {
    throw std::runtime_error("one-body motion: the body does not come back from the contact");
  }
}

Bounce OneBodyMotion::bounce(const MotionState& start) {
  const Force none = [](const Vector3d&, const Vector3d&) -> Vector3d { return Vector3d::Zero(); };
  const Force law = [this](const Vector3d& x, const Vector3d& v) { return force_by(pairing_, x, v); };
  const Force unswitched = [this](const Vector3d& x, const Vector3d& v) { return force_by(without_switches_, x, v); };
  const Force approaching = [&](const Vector3d& x, const Vector3d& v) {
    return v.z() > 0 ? unswitched(x, v) : law(x, v);
  };
  const Force pressing = [&](const Vector3d& x, const Vector3d& v) -> Vector3d {
    const Vector3d force = law(x, v);
    return force.z() != 0 ? force : unswitched(x, v);
  };
  const Event touches = [this](const Vector3d& x, const Vector3d&) { return depth(x); };
  const Event separates = [this](const Vector3d& x, const Vector3d&) { return -depth(x); };
  const Event turns = [](const Vector3d&, const Vector3d& v) { return v.z(); };
  const Event pulls = [&](const Vector3d& x, const Vector3d& v) { return -reflected(unswitched, x, v).z(); };
  const Event returns = [&start](const Vector3d& x, const Vector3d&) { return x.z() - start.x_Me.z(); };
  const auto continued = [this](const Force& force) -> Force {
    return [this, &force](const Vector3d& x, const Vector3d& v) { return reflected(force, x, v); };
  };

  Bounce bounce;
  MotionState state = start;
  advance_to(none, {touches}, state);
  bounce.touch = state;
  advance_to(continued(approaching), {turns}, state);
  bounce.deepest = state;
  bounce.deepest_force = contact_force(state.x_Me, Vector3d::Zero()).z();
  std::vector<Event> ends{separates};
  if (pairing_.law().damping_mode == DampingMode::no_tension) ends.push_back(pulls);
  advance_to(continued(pressing), ends, state);
  bounce.force_ends = state;
  if (depth(state.x_Me) > least_depth_) advance_to(law, {separates}, state);
  advance_to(none, {returns}, state);
  bounce.end = state;
  return bounce;
}

MotionState OneBodyMotion::slide(MotionState state, double t_end, double stop_speed_x) {
  const Force law = [this](const Vector3d& x, const Vector3d& v) { return force_by(pairing_, x, v); };
  std::vector<Event> events;
  if (stop_speed_x > 0) {
    events.emplace_back([=](const Vector3d&, const Vector3d& v) { return stop_speed_x - v.x(); });
  }
  advance(law, events, t_end, state);
  return state;
}

MotionState OneBodyMotion::settle(MotionState state, double rate, int decay_times, double& effective_steps) {
  constexpr int kLeg = 5;  // decay times; a leg's errors count as if made at its end
  effective_steps = 0;
  for (int elapsed = 0; elapsed < decay_times; elapsed += kLeg) {
    const auto before = work_.steps;
    state = slide(state, state.t + kLeg / rate);
    effective_steps = std::exp(-kLeg) * effective_steps + static_cast<double>(work_.steps - before);
  }
  return state;
}

}  // namespace pcm::compare
