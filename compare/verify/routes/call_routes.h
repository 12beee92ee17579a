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

/// Who is asked about what, and what the plain route answered there.
struct AnsweredState {
  const EngineSeam& seam;
  const fast::Pairing& pairing;
  const Pose& pose;
  const Velocity& velocity;
  const fast::Contact& whole;
  double step;  ///< F is moved by so much on the way there, m; in scenes it is turned besides, or turned in place
};

/// Asks by every route but the plain one and `motion`, and holds each answer against the plain one bit by bit;
/// `on_bound` hears of the answer that has a bound, `on_tangent` of that which has a tangent. `with_tangents`: false
/// where the engine refuses the tangent (refused_tangent.h), which nobody asks for then.
void hold_routes(const AnsweredState& state, bool with_tangents, fast::Workspace& workspace, Checks& checks,
                 const std::function<void(const fast::Contact&)>& on_bound,
                 const std::function<void(const fast::Contact&)>& on_tangent);

/// The same for the route `motion`: `before` is what F went through.
void hold_motion(const AnsweredState& state, const std::vector<MovingPose>& before, fast::Workspace& workspace,
                 Checks& checks);

}  // namespace pcm::compare
