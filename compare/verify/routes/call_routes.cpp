// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/routes/call_routes.h"

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <limits>
#include <string>

#include "compare/verify/bounds/bound_arithmetic.h"
#include "compare/verify/routes/contact_fields.h"
#include "compare/verify/routes/scene_counters.h"
#include "compare/verify/routes/wanted_presets.h"
#include "fast/base/geometry.h"
#include "fast/base/same_bits.h"

namespace pcm::compare {
namespace {

/// The finaliser of splitmix64 (Steele, Lea and Flood 2014): every bit of the result depends on every bit of x.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// What the bits drawn at a state are for.
enum class Draw : std::uint64_t { ask = 1, scene_ask, bodies, turn, known_pose_ask, ways };

/// 64 bits that depend on all bits of a state's doubles: those of coarse ones are in the upper half alone.
std::uint64_t bits_of(const Pose& pose, const Velocity& velocity, Draw purpose) {
  std::uint64_t hash = 0;
  const auto mix = [&hash](double x) { hash = mixed(hash + 0x9e3779b97f4a7c15 + std::bit_cast<std::uint64_t>(x)); };
  for (int k = 0; k < 9; ++k) mix(pose.A(k / 3, k % 3));
  for (const Eigen::Vector3d* v : {&pose.r, &velocity.v, &velocity.w})
    for (int k = 0; k < 3; ++k) mix((*v)[k]);
  return mixed(hash + static_cast<std::uint64_t>(purpose));
}

/// Seventeen switches from as many bits.
Ask drawn_ask(Route route, std::uint64_t bits) {
  Ask ask{route, {}, {}};
  const auto next = [&bits] {
    const bool bit = (bits & 1) != 0;
    bits >>= 1;
    return bit;
  };
  for (bool* wanted : {&ask.wanted.polygons, &ask.wanted.areas, &ask.wanted.force, &ask.wanted.elements,
                       &ask.wanted.bound, &ask.wanted.statistics})
    *wanted = next();
  for (bool* saving :
       {&ask.savings.broad_phase, &ask.savings.certificates, &ask.savings.first_crossing, &ask.savings.lazy_vertices,
        &ask.savings.one_sided, &ask.savings.velocities, &ask.savings.only_wanted, &ask.savings.filters,
        &ask.savings.known_poses, &ask.savings.coherence})
    *saving = next();
  ask.wanted.tangent = next();
  return ask;
}

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

/// Calls `ask`: with which words it refuses to answer; none where it does not.
template <class Call>
std::string refusal_of(const Call& ask) {
  try {
    ask();
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
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
void hold_known_pose(const EngineSeam& seam, const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                     const Ask& ask, const fast::Contact& whole, double step, fast::Workspace& workspace,
                     Checks& checks) {
  fast::PairingMemory memory(pairing);
  for (const double away : {step, 0.5 * step}) {
    Pose nearby = pose;
    nearby.r.x() += away;
    is_answered([&] { memory.evaluate(nearby, velocity, ask.wanted, workspace, ask.savings); });
  }
  const bool answered =
      is_answered([&] { memory.evaluate(pose, another(velocity), ask.wanted, workspace, ask.savings); });
  const fast::Contact& answer = seam.evaluate_known(memory, pose, velocity, ask, workspace);
  hold_route(Route::known_pose, whole, answer, ask.wanted, checks);
  hold_law_only(Route::known_pose, answered && keeps_poses(ask, pairing.scheme()), answer.work.law_only == 1, checks);
}

/// One of the 24 rotations that turn axes onto axes: products with it are exact.
Eigen::Matrix3d turn_of_axes(std::uint64_t which) {
  const auto first = static_cast<Eigen::Index>(which % 3),
             second = (first + 1 + static_cast<Eigen::Index>(which / 3 % 2)) % 3;
  const Eigen::Vector3d x = (which / 6 % 2 == 0 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(first);
  const Eigen::Vector3d y = (which / 12 % 2 == 0 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(second);
  Eigen::Matrix3d A;
  A << x, y, x.cross(y);
  return A;
}

/// The pairing's two bodies, E before F.
fast::Scene scene_of(const fast::Pairing& pairing, const Wanted& wanted, const fast::Savings& savings) {
  fast::Scene scene(savings);
  scene.add_body(pairing.surface_E());
  scene.add_body(pairing.surface_F());
  scene.add_pairing(0, 1, pairing.law(), pairing.mode(), pairing.scheme(), wanted);
  return scene;
}

/// Both bodies where they are to each other at the given state, each moving by half of it: E turned by turns of the
/// axes Q, at -Q r / 2 with velocity -Q v / 2, F at Q r / 2 with Q v / 2. Differences of these are exact. Where E
/// spins, too, by -Q w / 2, F's velocity is that at its marker besides.
struct TwoBodies {
  fast::BodyState E, F;
  Eigen::Vector3d carried_W = Eigen::Vector3d::Zero();  ///< velocity at F's marker by E's spin, m/s

  TwoBodies(const Pose& pose, const Velocity& velocity)
      : TwoBodies(pose, velocity, bits_of(pose, velocity, Draw::bodies) % 24,
                  bits_of(pose, velocity, Draw::bodies) / 24 % 2 == 0) {}

  TwoBodies(const Pose& pose, const Velocity& velocity, std::uint64_t turn, bool spins) {
    const Eigen::Matrix3d Q = turn_of_axes(turn);
    E.pose = {Q, -0.5 * (Q * pose.r)};
    F.pose = {Q * pose.A, 0.5 * (Q * pose.r)};
    E.velocity.v = -0.5 * (Q * velocity.v);
    F.velocity = {0.5 * (Q * velocity.v), Q * velocity.w};
    if (!spins) return;
    E.velocity.w = -0.5 * (Q * velocity.w);
    F.velocity.w = 0.5 * (Q * velocity.w);
    carried_W = E.velocity.w.cross(F.pose.r - E.pose.r);
    F.velocity.v += carried_W;
  }
};

/// A turn about one of the six half axes by the angle 2^-13, orthogonal but for roundings.
Eigen::Matrix3d small_turn(std::uint64_t which) {
  constexpr double t = 0x1p-14;  // The tangent of half the angle.
  const auto axis = static_cast<Eigen::Index>(which % 3), second = (axis + 1) % 3, third = (axis + 2) % 3;
  const double sine = (which / 3 % 2 == 0 ? 1.0 : -1.0) * (2 * t / (1 + t * t));
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R(second, second) = R(third, third) = (1 - t * t) / (1 + t * t);
  R(third, second) = sine;
  R(second, third) = -sine;
  return R;
}

Eigen::Vector3d centre_of_box(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : mesh.vertices) box.extend(x);
  return box.center();
}

/// F a step away. Either it is turned about its marker and moved by `step`: where it lies far off the marker, the turn
/// moves it by more. Or it is turned about the middle of its box, which stays: then nothing but the turn has moved it.
fast::BodyState stepped(const fast::BodyState& F, const TriangleMesh& mesh, double step, std::uint64_t which) {
  fast::BodyState nearby = F;
  nearby.pose.A = small_turn(which % 6) * F.pose.A;
  if (which / 6 % 2 == 0) {
    nearby.pose.r.x() += step;
  } else {
    const Eigen::Vector3d centre = centre_of_box(mesh);
    nearby.pose.r += F.pose.A * centre - nearby.pose.A * centre;
  }
  return nearby;
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
void hold_scene(const EngineSeam& seam, const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                const Ask& ask, bool remembering, const fast::Contact& whole, double step, fast::Workspace& workspace,
                Checks& checks) {
  fast::Scene scene = scene_of(pairing, ask.wanted, ask.savings);
  const TwoBodies bodies(pose, velocity);
  const std::uint64_t turn = bits_of(pose, velocity, Draw::turn);
  for (const double away : {step, 0.5 * step}) {
    scene.move({bodies.E, stepped(bodies.F, pairing.surface_F().mesh(), away, turn)});
    if (remembering) scene.remember_poses();
    is_answered([&] { scene.evaluate(0, workspace); });
  }
  bool is_known = false;
  if (remembering) {
    scene.move({bodies.E, {bodies.F.pose, another(bodies.F.velocity)}});
    scene.remember_poses();
    is_known = is_answered([&] { scene.evaluate(0, workspace); }) && keeps_poses(ask, pairing.scheme());
  }
  scene.move({bodies.E, bodies.F});
  if (!hold_relative_state(scene, pose, velocity, bodies.carried_W, checks)) return;
  const Pose relative = scene.relative_pose(0);
  const Velocity motion = scene.relative_velocity(0);
  if (fast::same_bits(relative, pose) && fast::same_bits(motion, velocity)) {
    const fast::Contact& answer = seam.evaluate_in(scene, workspace);
    hold_route(Route::scene, whole, answer, ask.wanted, checks);
    const fast::SceneCounters counters = seam.counters_of(scene);
    hold_counters(counters, answer.work, checks);
    if (counters.evaluated == 1) hold_law_only(Route::scene, is_known, counters.work.law_only == 1, checks);
    if (is_known && ask.wanted.force) {
      const Eigen::Vector3d force_Me = answer.force_Me, torque_Me = answer.torque_Me;  // the next question changes it
      hold_loads(seam, scene, bodies.E.pose.A, relative.r, force_Me, torque_Me, checks);
    }
    return;
  }
  Ask everything{Route::plain, {}, {}};
  everything.wanted.bound = ask.wanted.bound;
  everything.wanted.tangent = ask.wanted.tangent;
  const fast::Contact there = seam.evaluate(pairing, relative, motion, everything, workspace);
  hold_route(Route::scene, there, seam.evaluate_in(scene, workspace), ask.wanted, checks);
}

/// Holds that every route on which a tangent is asked for refuses it in these words.
void hold_refusal(const EngineSeam& seam, const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                  const std::string& refusal, fast::Workspace& workspace, Checks& checks) {
  const auto hold = [&](Route route, const auto& ask) {
    checks.checked(Kind::paths);
    const std::string said = refusal_of(ask);
    if (said == refusal) return;
    checks.add(Kind::paths, "{}: a tangent is refused with \"{}\", on another route with \"{}\"", name(route), said,
               refusal);
  };
  for (Ask ask : asks_at(pose, velocity)) {
    ask.wanted.tangent = true;
    hold(ask.route, [&] { seam.evaluate(pairing, pose, velocity, ask, workspace); });
  }
  fast::PairingMemory memory(pairing);
  for (Ask ask : known_pose_asks_at(pose, velocity)) {
    ask.wanted.tangent = true;
    hold(ask.route, [&] { seam.evaluate_known(memory, pose, velocity, ask, workspace); });
  }
  if (!is_pose_for_scenes(pose)) return;
  for (Ask ask : scene_asks_at(pose, velocity)) {
    ask.wanted.tangent = true;
    fast::Scene scene = scene_of(pairing, ask.wanted, ask.savings);
    scene.move({{}, {pose, velocity}});
    hold(ask.route, [&] { seam.evaluate_in(scene, workspace); });
  }
}

}  // namespace

std::string_view name(Route route) {
  constexpr std::array<std::string_view, 9> kNames = {"plain", "bounded",    "force", "touch", "tangent",
                                                      "drawn", "known pose", "scene", "motion"};
  return kNames[static_cast<std::size_t>(route)];
}

std::vector<Ask> asks_at(const Pose& pose, const Velocity& velocity) {
  Wanted with_bound;
  with_bound.bound = true;
  std::vector<Ask> asks = {{Route::plain, {}, {}},
                           {Route::bounded, with_bound, {}},
                           {Route::force, kForceOnly, {}},
                           {Route::touch, kTouchOnly, {}},
                           {Route::tangent, kForceAndTangent, {}}};
  asks.push_back(drawn_ask(Route::drawn, bits_of(pose, velocity, Draw::ask)));
  return asks;
}

const fast::Contact& EngineSeam::evaluate(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                          const Ask& ask, fast::Workspace& workspace) const {
  return fast::evaluate(pairing, pose, velocity, ask.wanted, workspace, ask.savings);
}

std::vector<Ask> known_pose_asks_at(const Pose& pose, const Velocity& velocity) {
  return {{Route::known_pose, {}, {}}, drawn_ask(Route::known_pose, bits_of(pose, velocity, Draw::known_pose_ask))};
}

std::vector<Ask> scene_asks_at(const Pose& pose, const Velocity& velocity) {
  return {{Route::scene, {}, {}}, drawn_ask(Route::scene, bits_of(pose, velocity, Draw::scene_ask))};
}

bool is_pose_for_scenes(const Pose& pose) {
  // Less what the product with a turn rounds.
  constexpr double kSkew = (1 - 0x1p-10) * 1e-10;
  return fast::orthogonality_error(pose.A) <= kSkew;
}

const fast::Contact& EngineSeam::evaluate_for_draw(const fast::Pairing& pairing, const Pose& pose,
                                                   const Velocity& velocity, const Wanted& wanted,
                                                   fast::Workspace& workspace) const {
  return fast::evaluate(pairing, pose, velocity, wanted, workspace);
}

const fast::Contact& EngineSeam::evaluate_known(fast::PairingMemory& memory, const Pose& pose, const Velocity& velocity,
                                                const Ask& ask, fast::Workspace& workspace) const {
  return memory.evaluate(pose, velocity, ask.wanted, workspace, ask.savings);
}

const fast::Contact& EngineSeam::evaluate_in(fast::Scene& scene, fast::Workspace& workspace) const {
  return scene.evaluate(0, workspace);
}

std::vector<fast::BodyLoad> EngineSeam::body_loads_in(fast::Scene& scene) const {
  scene.evaluate_all();
  return scene.body_loads();
}

fast::SceneCounters EngineSeam::counters_of(const fast::Scene& scene) const {
  return scene.counters();
}

const EngineSeam& EngineSeam::none() {
  static const EngineSeam passes;
  return passes;
}

void hold_routes(const EngineSeam& seam, const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                 const fast::Contact& whole, double step, fast::Workspace& workspace, Checks& checks,
                 const std::function<void(const fast::Contact&)>& on_bound, bool tangent_may_overflow,
                 const std::function<void(const fast::Contact&)>& on_tangent) {
  fast::Contact expected = whole;
  bool has_tangent = true;
  const auto with_what_there_is = [&](std::vector<Ask> asks) {
    if (!has_tangent)
      for (Ask& ask : asks) ask.wanted.tangent = false;
    return asks;
  };
  if (tangent_may_overflow) {
    const std::string refusal = refusal_of([&] {
      seam.evaluate(pairing, pose, velocity, {Route::tangent, kForceAndTangent, {}}, workspace);
    });
    has_tangent = refusal.empty();
    if (!has_tangent) hold_refusal(seam, pairing, pose, velocity, refusal, workspace, checks);
  }
  for (const Ask& ask : with_what_there_is(asks_at(pose, velocity))) {
    if (ask.route == Route::plain || (ask.route == Route::tangent && !has_tangent)) continue;
    const fast::Contact& answer = seam.evaluate(pairing, pose, velocity, ask, workspace);
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
  const std::vector<Ask> known_pose_asks = with_what_there_is(known_pose_asks_at(pose, velocity));
  hold_known_pose(seam, pairing, pose, velocity, known_pose_asks[ways % 2], expected, step, workspace, checks);
  if (!is_pose_for_scenes(pose)) return;
  const std::vector<Ask> asks = with_what_there_is(scene_asks_at(pose, velocity));
  for (std::size_t k = 0; k < asks.size(); ++k)
    hold_scene(seam, pairing, pose, velocity, asks[k], (ways >> (k + 1) & 1) != 0, expected, step, workspace, checks);
}

void hold_motion(const EngineSeam& seam, const fast::Pairing& pairing, const std::vector<MovingPose>& before,
                 const Pose& pose, const Velocity& velocity, const fast::Contact& whole, double step,
                 fast::Workspace& workspace, Checks& checks) {
  if (!is_pose_for_scenes(pose)) return;
  fast::Scene scene = scene_of(pairing, {}, {});
  const std::uint64_t turn = bits_of(pose, velocity, Draw::bodies) % 24;
  const auto ask_at = [&](const fast::BodyState& E, const fast::BodyState& F) {
    scene.move({E, F});
    return is_answered([&] { seam.evaluate_in(scene, workspace); });
  };
  const auto arrive = [&](const TwoBodies& bodies) {
    scene.move({bodies.E, bodies.F});
    scene.remember_poses();
  };
  // Each step as an implicit integrator takes it: the load, then difference quotients over velocity and place.
  for (const MovingPose& state : before) {
    const TwoBodies bodies(state.pose, state.velocity, turn, false);
    arrive(bodies);
    ask_at(bodies.E, bodies.F);
    ask_at(bodies.E, {bodies.F.pose, another(bodies.F.velocity)});
    ask_at(bodies.E, stepped(bodies.F, pairing.surface_F().mesh(), step, turn));
  }
  const TwoBodies bodies(pose, velocity, turn, false);
  arrive(bodies);
  if (!hold_relative_state(scene, pose, velocity, bodies.carried_W, checks)) return;
  const Pose relative = scene.relative_pose(0);
  const Velocity motion = scene.relative_velocity(0);
  const Wanted everything;
  fast::Contact there = whole;
  if (!fast::same_bits(relative, pose) || !fast::same_bits(motion, velocity))
    there = seam.evaluate(pairing, relative, motion, {Route::plain, {}, {}}, workspace);
  const fast::Contact& at_once = seam.evaluate_in(scene, workspace);
  hold_route(Route::motion, there, at_once, everything, checks);
  hold_counters(seam.counters_of(scene), at_once.work, checks);
  const bool is_known = ask_at(bodies.E, {bodies.F.pose, another(bodies.F.velocity)});
  scene.move({bodies.E, bodies.F});
  hold_route(Route::motion, there, seam.evaluate_in(scene, workspace), everything, checks);
  const fast::SceneCounters counters = seam.counters_of(scene);
  if (counters.evaluated == 1) hold_law_only(Route::motion, is_known, counters.work.law_only == 1, checks);
  hold_loads(seam, scene, bodies.E.pose.A, relative.r, there.force_Me, there.torque_Me, checks);
}

}  // namespace pcm::compare
