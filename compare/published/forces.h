// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "compare/published/workspace.h"
#include "fast/force/element_sum.h"

/// What both published algorithms share with the engine: the question, the law of PCM section 7 and the sums.
namespace pcm::compare::published {

/// Checks the question, empties the answer, keeping its memory, and places both surfaces.
void begin(const Surface& surface_E, const Surface& surface_F, const Pose& pose, const Velocity& velocity,
           const Wanted& wanted, Workspace& workspace);

/// Adds the element of a master face (7), (13) to (24) where its line leaves the slave through what it meets first, at
/// u > 0, clamped to `max_penetration`, m.
void add_element(Side master, Index face, const fast::FaceGeometry& geometry, const FirstMet& first,
                 double max_penetration, fast::ElementSum& sum);

/// Forms the elements of one master.
using SumElements = std::function<fast::MasterForce(Side master, const fast::ForceProblem& problem)>;

/// Force and torque (23), (24); in mode `both` the mean of both masters'. Throws BadInput where they are not finite.
void compute_force(Workspace& workspace, const ContactLaw& law, Mode mode, const Pose& pose, const Velocity& velocity,
                   const Wanted& wanted, const SumElements& sum_elements);

}  // namespace pcm::compare::published
