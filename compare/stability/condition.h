// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/stability/exact_contact.h"

namespace pcm::compare::stability {

/// The poses that differ from this one in one number, r's three and A's nine, by an ulp of it away from zero: the
/// distance from its absolute value to the next greater double. Changing a number of A is a rotation and a stretch of
/// that size; A remains a rotation to a few ulps.
std::vector<Pose> poses_an_ulp_away(const Pose& pose);

/// The condition of the problem at a pose: how far the exact answer moves as the pose goes to one of those, the
/// greatest distance of each quantity, N, N m, m^2, m. A pose is known no better than that to whoever keeps it in
/// doubles, so no engine can be expected to have a smaller error in what it is meant to answer. Where an ulp changes
/// the elements of the barycentric scheme this is the jump of the force.
Figures movement_by_an_ulp(const ExactBodies& bodies, const Pose& pose, Scheme scheme, ExactContact& truth);

}  // namespace pcm::compare::stability
