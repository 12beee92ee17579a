// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/verify/bounds/question.h"
#include "pcm/contact.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// How far a right engine's tangent may be from the oracle's on the same rounded problem, entry by entry: each
/// element's share worked out once more, by hand, from the oracle's element and the bounds on it (RoundingBounds), with
/// running errors (UncertainNumber). Barycentric scheme. `true_rounded` has its elements. Infinite where roundings may
/// leave nothing of the angle between two faces, or of the direction of slip without v_eps.
fast::Tangent tangent_bounds(const Question& question, const reference::Answer& true_rounded);

}  // namespace pcm::compare
