// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/savings.h"

/// The ways by which callers reach the engine. Each takes other code; all answers must be one, bit for bit. Threads
/// within an evaluation are none of them, for they take no part in contacts as small as those of the poses here: tests
/// hold them to the same bits (tests/fast/engine/workspace_threads_test.cpp).
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

/// What the bits drawn at a state are for.
enum class Draw : std::uint64_t { ask = 1, scene_ask, bodies, turn, known_pose_ask, ways };

/// 64 bits that depend on all bits of a state's doubles: those of coarse ones are in the upper half alone.
std::uint64_t bits_of(const Pose& pose, const Velocity& velocity, Draw purpose);

}  // namespace pcm::compare
