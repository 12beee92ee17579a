// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "fast/active/intersection.h"
#include "fast/barycentric/barycentric_elements.h"
#include "fast/bounds/barycentric_bound.h"
#include "fast/bounds/clipped_bound.h"
#include "fast/clipped/clipped_elements.h"

namespace pcm::fast {

/// Scratch memory of compute_force.
struct ForceScratch {
  BarycentricScratch barycentric;
  ClippedScratch clipped;
  UndecidedFaces undecided;  ///< of the master at hand
  BarycentricBoundScratch barycentric_bound;
  ClippedBoundScratch clipped_bound;
};

/// Of either master.
using LineMemories = std::array<LineMemory, 2>;

/// Force and torque of a pairing (23), (24), with a bound where it is wanted.
struct PairingForce {
  MasterForce total;
  std::optional<ForceBound> bound;
};

/// Of the master's elements, in mode `both` the mean of both masters'. Records the elements. Throws BadInput where
/// force or torque overflow. `memories`: of the penetration lines at the last pose, or nullptr. Where a bound is
/// wanted, one thread of the team forms the elements that it is of; a tangent is still found by all of them.
PairingForce compute_force(const Intersection& intersection, Scheme scheme, Mode mode, const ForceProblem& problem,
                           bool with_bound, PosedTeam& team, ForceScratch& scratch, LineMemories* memories,
                           ElementRecord& record);

/// Of elements that were found at the problem's pose and kept: the law, at another velocity, in the same order and to
/// the bits of compute_force, which throws likewise. Records what velocities change.
MasterForce repeat_force(const FoundElements& found, Mode mode, const ForceProblem& problem, ForceScratch& scratch,
                         ElementRecord& record, WorkCounters& work);

/// Forms the elements that modes E and F do without, and forgets them: what a one-sided mode saves.
void form_elements_of_slave(const Intersection& intersection, Scheme scheme, Mode mode, const ForceProblem& problem,
                            PosedTeam& team, ForceScratch& scratch);

}  // namespace pcm::fast
