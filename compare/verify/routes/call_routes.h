// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "compare/poses/strata.h"
#include "compare/verify/verdict/checks.h"
#include "pcm/engine.h"
#include "pcm/pairing_memory.h"
#include "pcm/scene.h"

/// The ways by which callers reach the engine. Each takes other code; all answers must be one, bit for bit.
namespace pcm::compare {

enum class Route : std::uint8_t {
  plain,    ///< everything but a bound, as Wanted is by default: this answer is held against the oracle
  bounded,  ///< everything and a bound
  force,    ///< force and torque only
  touch,    ///< whether the surfaces cross only
  tangent,  ///< force, torque and their derivatives only
  drawn,    ///< a choice of Wanted and Savings drawn from the pose's own bits, so that it is drawn again
  /// A fast::PairingMemory that was asked about two places nearby, and then about another velocity there: by default or
  /// with drawn choices.
  known_pose,
  /// Two bodies of a fast::Scene, after two steps from a place nearby: by default, and with drawn choices; each at
  /// once, or when it was asked about other velocities there and remembers the pose, and then what acts on either body
  /// too.
  scene,
  /// Two bodies of a fast::Scene that has followed them along what went before, as an integrator does, and remembers
  /// every pose: by default, at once and again when it was asked about another velocity there. Only where that is
  /// given.
  motion,
};

std::string_view name(Route route);

/// A question to the engine.
struct Ask {
  Route route = Route::plain;
  Wanted wanted;
  fast::Savings savings;
};

/// What `evaluate` is asked at every pose: the plain question first.
std::vector<Ask> asks_at(const Pose& pose, const Velocity& velocity);

/// What a fast::PairingMemory may be asked there: everything but a bound with all savings, or a choice drawn apart.
std::vector<Ask> known_pose_asks_at(const Pose& pose, const Velocity& velocity);

/// What scenes are asked there: everything but a bound with all savings, then a choice drawn apart from that of
/// `drawn`.
std::vector<Ask> scene_asks_at(const Pose& pose, const Velocity& velocity);

/// Whether A is a rotation to 1e-10, as scenes demand of every body's: no scene is asked about other poses.
bool is_pose_for_scenes(const Pose& pose);

/// Stands between the engine and the comparison. This one lets answers pass; tests put others in its place, which alter
/// them, to see the comparison notice.
class EngineSeam {
 public:
  EngineSeam() = default;
  EngineSeam(const EngineSeam&) = delete;
  EngineSeam& operator=(const EngineSeam&) = delete;
  virtual ~EngineSeam() = default;

  /// The answer lives until the next call with that workspace. Throws as fast::evaluate does.
  virtual const fast::Contact& evaluate(const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                        const Ask& ask, fast::Workspace& workspace) const;
  /// Elements that a law's thresholds are drawn at (state_draw.h).
  virtual const fast::Contact& evaluate_for_draw(const fast::Pairing& pairing, const Pose& pose,
                                                 const Velocity& velocity, const Wanted& wanted,
                                                 fast::Workspace& workspace) const;
  virtual const fast::Contact& evaluate_known(fast::PairingMemory& memory, const Pose& pose, const Velocity& velocity,
                                              const Ask& ask, fast::Workspace& workspace) const;
  /// The answer of a scene's only pairing, where its bodies are.
  virtual const fast::Contact& evaluate_in(fast::Scene& scene, fast::Workspace& workspace) const;
  /// What acts on its two bodies there.
  virtual std::vector<fast::BodyLoad> body_loads_in(fast::Scene& scene) const;
  /// What it has counted since its last move.
  virtual fast::SceneCounters counters_of(const fast::Scene& scene) const;

  /// The one that lets answers pass.
  static const EngineSeam& none();
};

/// Asks by every route but the plain one and `motion`, and holds each answer against the plain one, `whole`, bit by
/// bit; `on_bound` hears of the answer that has a bound, `on_tangent` of that which has a tangent. A tangent that may
/// be beyond all doubles may be refused, by all routes in the same words, and is asked for no more then. `step`: a
/// length by which F is moved first, m; in scenes it is turned besides, or turned in place.
void hold_routes(const EngineSeam& seam, const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                 const fast::Contact& whole, double step, fast::Workspace& workspace, Checks& checks,
                 const std::function<void(const fast::Contact&)>& on_bound, bool tangent_may_overflow,
                 const std::function<void(const fast::Contact&)>& on_tangent);

/// The same for the route `motion`; `step` as there.
void hold_motion(const EngineSeam& seam, const fast::Pairing& pairing, const std::vector<MovingPose>& before,
                 const Pose& pose, const Velocity& velocity, const fast::Contact& whole, double step,
                 fast::Workspace& workspace, Checks& checks);

}  // namespace pcm::compare
