// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/verify/bounds/question.h"
#include "pcm/contact.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// How far a right engine's tangent may be from the oracle's on the same rounded problem, entry by entry: each
/// element's share worked out once more, by hand, from the oracle's element and the bounds on it (RoundingBounds,
/// ClippedBounds), with running errors (UncertainNumber). `true_rounded` has the elements. In the barycentric scheme
/// depths grow by the angle between two faces, which is all that moves; in the clipped scheme elements move as the
/// oracle's do, within part_motion_error. Infinite where roundings may leave nothing of the angle between two faces, or
/// of the direction of slip without v_eps. Where loads are linear in the elements' integrals, as nothing damps or rubs,
/// or nothing moves, those errors that neighbours make up for are left out (ErrorOf::linear_sums). A sliver of the
/// clipped scheme may be missing, and counts with all that it may add (sliver_slopes.h).
fast::Tangent tangent_bounds(const Question& question, const reference::Answer& true_rounded,
                             const std::vector<reference::ElementMotion>& motions);

}  // namespace pcm::compare
