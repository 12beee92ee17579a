// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/hard_poses/goal.h"
#include "compare/hard_poses/hard_state.h"
#include "compare/random/random.h"

namespace pcm::compare {

/// A state beside another one, by one change of a drawn share s of 2^-52 to 2^-4, so that scales from roundings to
/// features are tried alike:
///
/// - three eighths: F moved along an axis of Me by up to s sizes of the smaller body; an eighth: turned by up to s rad;
/// - an eighth: one vertex of either surface moved along an axis of its frame by up to s sizes of that surface, where
///   both together have at most 200 faces, else F is moved;
/// - an eighth: another mode, but for margins, which have none: there F is turned;
/// - two eighths, where law and velocity have a part in the goal, else F is turned: a component of the velocity changed
///   by up to s sizes a second (rad/s), a number of the law that is neither 0 nor infinite by up to s of itself, or in
///   one of eight of these all of the law drawn anew for the pose (state_draw.h).
///
/// A pure function of the state and the random numbers, by correctly rounded operations only. Throws BadInput where a
/// moved vertex leaves a surface unfit for contact, and where a number of the law leaves the range of what can be asked
/// (question_range.h); DrawFailure as draw_state does.
HardState neighbour(const HardState& from, Goal goal, PoseRandom& random);

}  // namespace pcm::compare
