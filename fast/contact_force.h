// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/contact_elements.h"

namespace pcm::fast {

/// The problem that answers what is wanted, and no more. `statistics` gathers the elements where they are asked for; it
/// and what else is given must outlive the problem.
ForceProblem force_problem(Scheme scheme, const ContactLaw& law, const Pose& pose, const Velocity& velocity,
                           const Wanted& wanted, StatisticsSum& statistics);

/// Fills an element's position (13), velocities (16), (17), (19) and forces (14), (15), (18), (20), (21). `element`
/// brings its master, area, penetration and normal; `foot_Me` is C_e or the centre of pressure. Velocities stay 0 where
/// the problem needs none.
void apply_force(const ForceProblem& problem, const Eigen::Vector3d& foot_Me, Element& element);

/// The same for WideElements::force.
ForceLimits force_limits(const ForceProblem& problem, Side master);

/// Force and torque of the pairing (23), (24): of the master's elements, in mode `both` the mean of both masters'.
/// Fills the answer's force, torque, elements, counts and statistics.
void compute_force(Workspace::Data& workspace, Mode mode, const ForceProblem& problem);

/// Throws BadInput where the answer's force or torque overflowed.
void require_finite_force(const Contact& contact);

/// Forms the elements that modes E and F do without, and forgets them: what a one-sided mode saves.
void form_elements_of_slave(Workspace::Data& workspace, Mode mode, const ForceProblem& problem);

}  // namespace pcm::fast
