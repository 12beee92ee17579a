// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/verify/routes/engine_seam.h"
#include "compare/verify/verdict/checks.h"

/// Tangents that the engine refuses for they are beyond all doubles.
namespace pcm::compare {

/// With which words it refuses the tangent at this state; none where it does not.
std::string refusal_of_tangent(const EngineSeam& seam, const fast::Pairing& pairing, const Pose& pose,
                               const Velocity& velocity, fast::Workspace& workspace);

/// Holds that every route on which a tangent is asked for refuses it in these words.
void hold_refusal(const EngineSeam& seam, const fast::Pairing& pairing, const Pose& pose, const Velocity& velocity,
                  const std::string& refusal, fast::Workspace& workspace, Checks& checks);

/// The same law but for stiffness and damping, which are 2^-128 times as great: so are all forces and tangents, to the
/// bit where nothing underflows.
ContactLaw weakened(const ContactLaw& law);

/// Holds that a tangent under the weakened law, or a sum on the way to it (kGreatestOnTheWay), would be beyond all
/// doubles under the law itself.
void hold_beyond_doubles(const fast::Tangent& under_weakened_law, Checks& checks);

}  // namespace pcm::compare
