// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/routes/call_routes.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "compare/verify/bounds/bound_arithmetic.h"
#include "compare/verify/routes/contact_fields.h"
#include "compare/verify/routes/refusal.h"
#include "compare/verify/routes/scene_counters.h"
#include "compare/verify/routes/two_bodies.h"
#include "fast/base/same_bits.h"

namespace pcm::compare {
namespace {

void hold_route(Route route, const fast::Contact& whole, const fast::Contact& answer, const Wanted& wanted,
                Checks& checks) {
  checks.checked(Kind::paths);
  if (const std::string difference = difference_in_bits(whole, answer, wanted); !difference.empty())
    checks.add(Kind::paths, "{}: {}", name(route), difference);
}

/// At rest it has other bits, and the same value.
Velocity another(const Velocity& velocity) {
  return {-0.5 * velocity.v, -0.5 * velocity.w};
}

/// Whether a pose is known after an answer there.
bool keeps_poses(const Ask& ask, Scheme scheme) {
  const bool hangs_on_elements = !ask.wanted.bound && !(ask.wanted.tangent && scheme == Scheme::clipped);
  return ask.savings.known_poses && ask.savings.only_wanted && hangs_on_elements;
}

/// Calls `ask`; false where it throws: on the way to a question, the force may be beyond all doubles.
template <class Call>
bool is_answered(const Call& ask) {
  return refusal_of(ask).empty();
}

void hold_law_only(Route route, bool expected, bool found, Checks& checks) {
  checks.checked(Kind::paths);
  if (found != expected) checks.add(Kind::paths, "{}: the law alone was {}applied", name(route), found ? "" : "not ");
}

/// Asks beside the pose first, twice, which leaves elements that are not those of the pose and pairs that are followed.
void hold_known_pose(const AnsweredState& state, const Ask& ask, const fast::Contact& whole, fast::Workspace& workspace,
                     Checks& checks) {
  const Pose& pose = state.pose;
  const Velocity& velocity = state.velocity;
  fast::PairingMemory memory(state.pairing);
  for (const double away : {state.step, 0.5 * state.step}) {
    Pose nearby = pose;
    nearby.r.x() += away;
    is_answered([&] { memory.evaluate(nearby, velocity, ask.wanted, workspace, ask.savings); });
  }
  const bool answered =
      is_answered([&] { memory.evaluate(pose, another(velocity), ask.wanted, workspace, ask.savings); });
  const fast::Contact& answer = state.seam.evaluate_known(memory, pose, velocity, ask, workspace);
  hold_route(Route::known_pose, whole, answer, ask.wanted, checks);
  hold_law_only(Route::known_pose, answered && keeps_poses(ask, state.pairing.scheme()), answer.work.law_only == 1,
                checks);
}

/// Holds what the scene says of its pairing and its bodies against the answer's force and torque. E's axes are those of
/// W in another order, so that no product with its A is rounded, and the torque about E is rounded as here.
void hold_loads(const EngineSeam& seam, fast::Scene& scene, const Eigen::Matrix3d& A_WE, const Eigen::Vector3d& r_Me,
                const Eigen::Vector3d& force_Me, const Eigen::Vector3d& torque_Me, Checks& checks) {
  checks.checked(Kind::paths);
  const std::vector<fast::BodyLoad> loads = seam.body_loads_in(scene);
  const fast::PairingLoad& load = scene.load(0);
  const Eigen::Vector3d about_E_Me = torque_Me + r_Me.cross(force_Me);
  if (!fast::same_bits(load.force_Me, force_Me) || !fast::same_bits(load.torque_Me, torque_Me))
    checks.add(Kind::paths, "{}: the load kept of the pairing is another", name(Route::scene));
  if (loads[0].force_W != A_WE * force_Me || loads[0].torque_W != A_WE * about_E_Me ||
      loads[1].force_W != -(A_WE * force_Me) || loads[1].torque_W != -(A_WE * torque_Me))
    checks.add(Kind::paths, "{}: force or torque on a body is not that of its pairing", name(Route::scene));
}

/// Holds where the scene says that F is to E. `carried_W`: what E's spin adds to F's velocity.
bool hold_relative_state(const fast::Scene& scene, const Pose& pose, const Velocity& velocity,
                         const Eigen::Vector3d& carried_W, Checks& checks) {
  const Pose relative = scene.relative_pose(0);
  const Velocity motion = scene.relative_velocity(0);
  // Halves of the smallest doubles are rounded. Each of three sums rounds the velocity where E spins.
  constexpr double kLeast = 2 * std::numeric_limits<double>::denorm_min();
  const double carried = carried_W.cwiseAbs().maxCoeff();
  const double rounding = carried == 0 ? 0 : 4 * kRoundoff * (velocity.v.cwiseAbs().maxCoeff() + carried);
  if (relative.A != pose.A || !((relative.r - pose.r).cwiseAbs().maxCoeff() <= kLeast) ||
      !((motion.v - velocity.v).cwiseAbs().maxCoeff() <= rounding + kLeast) ||
      !((motion.w - velocity.w).cwiseAbs().maxCoeff() <= kLeast)) {
    checks.add(Kind::paths, "{}: relative pose or velocity of two moving bodies is another", name(Route::scene));
    return false;
  }
  return true;
}

/// Holds a scene's answer against `whole`, the one to everything and a bound. A step on the way makes the scene look
/// for a certificate where the bodies are apart, and use it where it still holds. With `remembering` F then has another
/// velocity first where it is asked for, and loads, which cost little there, are held too.
void hold_scene(const AnsweredState& state, const Ask& ask, bool remembering, const fast::Contact& whole,
                fast::Workspace& workspace, Checks& checks) {
  const Pose& pose = state.pose;
  const Velocity& velocity = state.velocity;
  fast::Scene scene = scene_of(state.pairing, ask.wanted, ask.savings);
  const TwoBodies bodies(pose, velocity);
  const std::uint64_t turn = bits_of(pose, velocity, Draw::turn);
  for (const double away : {state.step, 0.5 * state.step}) {
    scene.move({bodies.E, stepped(bodies.F, state.pairing.surface_F().mesh(), away, turn)});
    if (remembering) scene.remember_poses();
    is_answered([&] { scene.evaluate(0, workspace); });
  }
  bool is_known = false;
  if (remembering) {
    scene.move({bodies.E, {bodies.F.pose, another(bodies.F.velocity)}});
    scene.remember_poses();
    is_known = is_answered([&] { scene.evaluate(0, workspace); }) && keeps_poses(ask, state.pairing.scheme());
  }
  scene.move({bodies.E, bodies.F});
  if (!hold_relative_state(scene, pose, velocity, bodies.carried_W, checks)) return;
  const Pose relative = scene.relative_pose(0);
  const Velocity motion = scene.relative_velocity(0);
  if (fast::same_bits(relative, pose) && fast::same_bits(motion, velocity)) {
    const fast::Contact& answer = state.seam.evaluate_in(scene, workspace);
    hold_route(Route::scene, whole, answer, ask.wanted, checks);
    const fast::SceneCounters counters = state.seam.counters_of(scene);
    hold_counters(counters, answer.work, checks);
    if (counters.evaluated == 1) hold_law_only(Route::scene, is_known, counters.work.law_only == 1, checks);
    if (is_known && ask.wanted.force) {
      const Eigen::Vector3d force_Me = answer.force_Me, torque_Me = answer.torque_Me;  // the next question changes it
      hold_loads(state.seam, scene, bodies.E.pose.A, relative.r, force_Me, torque_Me, checks);
    }
    return;
  }
  Ask everything{Route::plain, {}, {}};
  everything.wanted.bound = ask.wanted.bound;
  everything.wanted.tangent = ask.wanted.tangent;
  const fast::Contact there = state.seam.evaluate(state.pairing, relative, motion, everything, workspace);
  hold_route(Route::scene, there, state.seam.evaluate_in(scene, workspace), ask.wanted, checks);
}

}  // namespace

void hold_routes(const AnsweredState& state, bool with_tangents, fast::Workspace& workspace, Checks& checks,
                 const std::function<void(const fast::Contact&)>& on_bound,
                 const std::function<void(const fast::Contact&)>& on_tangent) {
  const Pose& pose = state.pose;
  const Velocity& velocity = state.velocity;
  fast::Contact expected = state.whole;
  const auto allowed = [with_tangents](std::vector<Ask> asks) {
    if (!with_tangents)
      for (Ask& ask : asks) ask.wanted.tangent = false;
    return asks;
  };
  for (const Ask& ask : allowed(asks_at(pose, velocity))) {
    if (ask.route == Route::plain || (ask.route == Route::tangent && !with_tangents)) continue;
    const fast::Contact& answer = state.seam.evaluate(state.pairing, pose, velocity, ask, workspace);
    hold_route(ask.route, expected, answer, ask.wanted, checks);
    if (ask.route == Route::bounded) {
      expected.bound = answer.bound;  // others that have a bound have this one
      on_bound(answer);
    } else if (ask.route == Route::tangent) {
      expected.tangent = answer.tangent;
      on_tangent(answer);
    }
  }
  // Of two questions, and of two ways to ask a scene, each state takes one: all of them would cost a half more.
  const std::uint64_t ways = bits_of(pose, velocity, Draw::ways);
  const std::vector<Ask> known_pose_asks = allowed(known_pose_asks_at(pose, velocity));
  hold_known_pose(state, known_pose_asks[ways % 2], expected, workspace, checks);
  if (!is_pose_for_scenes(pose)) return;
  const std::vector<Ask> asks = allowed(scene_asks_at(pose, velocity));
  for (std::size_t k = 0; k < asks.size(); ++k)
    hold_scene(state, asks[k], (ways >> (k + 1) & 1) != 0, expected, workspace, checks);
}

void hold_motion(const AnsweredState& state, const std::vector<MovingPose>& before, fast::Workspace& workspace,
                 Checks& checks) {
  const Pose& pose = state.pose;
  const Velocity& velocity = state.velocity;
  if (!is_pose_for_scenes(pose)) return;
  fast::Scene scene = scene_of(state.pairing, {}, {});
  const std::uint64_t turn = bits_of(pose, velocity, Draw::bodies) % 24;
  const auto ask_at = [&](const fast::BodyState& E, const fast::BodyState& F) {
    scene.move({E, F});
    return is_answered([&] { state.seam.evaluate_in(scene, workspace); });
  };
  const auto arrive = [&](const TwoBodies& bodies) {
    scene.move({bodies.E, bodies.F});
    scene.remember_poses();
  };
  // Each step as an implicit integrator takes it: the load, then difference quotients over velocity and place.
  for (const MovingPose& earlier : before) {
    if (!is_pose_for_scenes(earlier.pose)) continue;
    const TwoBodies bodies(earlier.pose, earlier.velocity, turn, false);
    arrive(bodies);
    ask_at(bodies.E, bodies.F);
    ask_at(bodies.E, {bodies.F.pose, another(bodies.F.velocity)});
    ask_at(bodies.E, stepped(bodies.F, state.pairing.surface_F().mesh(), state.step, turn));
  }
  const TwoBodies bodies(pose, velocity, turn, false);
  arrive(bodies);
  if (!hold_relative_state(scene, pose, velocity, bodies.carried_W, checks)) return;
  const Pose relative = scene.relative_pose(0);
  const Velocity motion = scene.relative_velocity(0);
  const Wanted everything;
  fast::Contact there = state.whole;
  if (!fast::same_bits(relative, pose) || !fast::same_bits(motion, velocity))
    there = state.seam.evaluate(state.pairing, relative, motion, {Route::plain, {}, {}}, workspace);
  const fast::Contact& at_once = state.seam.evaluate_in(scene, workspace);
  hold_route(Route::motion, there, at_once, everything, checks);
  hold_counters(state.seam.counters_of(scene), at_once.work, checks);
  const bool is_known = ask_at(bodies.E, {bodies.F.pose, another(bodies.F.velocity)});
  scene.move({bodies.E, bodies.F});
  hold_route(Route::motion, there, state.seam.evaluate_in(scene, workspace), everything, checks);
  const fast::SceneCounters counters = state.seam.counters_of(scene);
  if (counters.evaluated == 1) hold_law_only(Route::motion, is_known, counters.work.law_only == 1, checks);
  hold_loads(state.seam, scene, bodies.E.pose.A, relative.r, there.force_Me, there.torque_Me, checks);
}

}  // namespace pcm::compare
