// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/engine/tracking.h"
#include "fast/force/force_problem.h"
#include "pcm/engine.h"

/// Of the engine, what this room needs beside <pcm/engine.h>.
namespace pcm::fast {

/// The law, with what is wanted and what the savings leave.
ForceProblem force_problem(const Pairing& pairing, const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                           const Savings& savings);

/// What an evaluation leaves for later ones of the same pairing.
struct Kept {
  bool found = false;            ///< elements as they were found, in the workspace's record; where no bound is wanted
  Tracking* tracking = nullptr;  ///< the pairing's, or none
};

/// `evaluate` for callers that hold a DefaultFloatingPoint. The answer is the workspace's own.
Contact& evaluate_and_keep(const Pairing& pairing, const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                           Workspace& workspace, const Savings& savings, const Kept& kept);

/// Whether an evaluation may follow what crosses from pose to pose: elsewhere it is asked for more, or for less saving,
/// than tracking knows of.
inline bool may_track(const Wanted& wanted, const Savings& savings) {
  return savings.coherence && savings.filters && !wanted.bound;
}

}  // namespace pcm::fast
