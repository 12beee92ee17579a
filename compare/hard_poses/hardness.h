// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "compare/hard_poses/goal.h"
#include "compare/verify/routes/held_pairing.h"

namespace pcm::compare {

/// How hard a state is, measured as the goal says; the greater, the harder. In the pairing's mode number `mode`:
///
/// - margins: 1 over the least margin (least_margin.h), 0 where there is none; of bodies and pose alone.
/// - exact decisions, work: counted by the engine when it is asked for everything. Steps: pairs of nodes, rows of
///   faces, decisions, elements, lines and searches, each of some ten nanoseconds.
/// - error over bound: |engine's - exact problem's| over the engine's bound on that, the greatest over the components
///   of force and torque in Me: at most 1 where the bound keeps its promise. The exact one is rounded to doubles first.
///   0 where both are equal and where the bound is infinite; infinite where anything is NaN.
/// - bound over error: the bound on the force over its error, both as lengths. The error counts as no less than 2^-53
///   of the forces that the elements would have with all of their master faces: less is luck, or the element a sliver
///   or a force that cancels. 0 where the bound is infinite, and without elements.
///
/// The last two are 0 where the bound says `flipped`: it is what one element more or less would change then, and is
/// used up wherever that comes true. What law and velocity have a part in is measured under those of the state.
/// Throws as engine and oracle do.
double hardness(Goal goal, const HeldPairing& held, std::size_t mode, const HeldPairing::State& state,
                fast::Workspace& workspace);

}  // namespace pcm::compare
