// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "compare/poses/strata.h"
#include "compare/verify/routes/engine_seam.h"
#include "compare/verify/verdict/checks.h"

/// One state asked about by every route (asks.h), and all answers held to be one.
namespace pcm::compare {

/// Asks by every route but the plain one and `motion`, and holds each answer against the plain one, `whole`, bit by
/// bit; `on_bound` hears of the answer that has a bound, `on_tangent` of that which has a tangent. `step`: a length by
/// which F is moved first, m; in scenes it is turned besides, or turned in place. `with_tangents`: false where the
/// engine refuses the tangent (refused_tangent.h), which nobody asks for then.
void hold_routes(const EngineSeam& seam, const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                 const fast::Contact& whole, double step, bool with_tangents, fast::Workspace& workspace,
                 Checks& checks, const std::function<void(const fast::Contact&)>& on_bound,
                 const std::function<void(const fast::Contact&)>& on_tangent);

/// The same for the route `motion`; `step` as there.
void hold_motion(const EngineSeam& seam, const fast::Pairing& pairing, const std::vector<MovingPose>& before,
                 const Pose& pose, const Velocity& velocity, const fast::Contact& whole, double step,
                 fast::Workspace& workspace, Checks& checks);

}  // namespace pcm::compare
