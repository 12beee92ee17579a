// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/force/force_problem.h"
#include "pcm/engine.h"

/// Of the engine, what this room needs beside <pcm/engine.h>.
namespace pcm::fast {

/// The law, with what is wanted and what the savings leave.
ForceProblem force_problem(const Pairing& pairing, const Pose& pose, const Velocity& velocity, const Wanted& wanted,
                           const Savings& savings);

/// `evaluate` for callers that hold a DefaultFloatingPoint; elements are kept as they were found in the workspace's
/// record, where no bound is wanted. The answer is the workspace's own.
Contact& evaluate_and_keep_found(const Pairing& pairing, const Pose& pose, const Velocity& velocity,
                                 const Wanted& wanted, Workspace& workspace, const Savings& savings);

}  // namespace pcm::fast
