// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/hard_poses/hard_state.h"
#include "compare/hard_poses/hardness.h"

/// States that are searched for, because they are hard for the engine.
namespace pcm::compare {

/// Where a climb ended.
struct Climb {
  HardState hardest;
  double begun_at = 0;  ///< hardness where it began; -1 where engine or oracle refuses that
  double reached = 0;
};

/// Draws 64 states, each of the strata generic, grazing, degenerate, near-degenerate and adversarial in turn, in any of
/// three modes, with a law and a velocity of their own where these have a part in the goal; then climbs from the
/// hardest. Where nothing that is drawn is hard at all, the first is where the climb begins.
///
/// A pure function of the surfaces and the random numbers, by correctly rounded operations only.
/// Cost: 448 questions to the engine, and to the oracle where the goal asks it: 0.02 to 2 s for bodies of some dozen
/// faces.
Climb climb(Goal goal, const HardState& surfaces, PoseRandom random, fast::Workspace& workspace);

/// From a given state: 384 times a neighbour (neighbour.h) is drawn, and taken unless it is easier, or engine or oracle
/// refuses it. Where hardness does not change the climb walks on. Whatever else they throw is as hard as can be, and
/// ends the climb.
Climb climb_from(Goal goal, const HardState& start, PoseRandom random, fast::Workspace& workspace);

}  // namespace pcm::compare
