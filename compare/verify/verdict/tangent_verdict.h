// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/verify/bounds/question.h"
#include "compare/verify/verdict/checks.h"
#include "pcm/contact.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// How far the engine's tangent may be from the oracle's of the rounded problem, entry by entry: tangent_bounds, and
/// what the oracle leaves open. `true_rounded` has the oracle's elements, `found` are the engine's: where it alone has
/// one, a sliver, nothing is known.
fast::Tangent allowed_errors(const Question& question, const std::vector<fast::Element>& found,
                             const reference::Answer& true_rounded, const reference::Tangent& truth);

/// How much greater a sum on the way to a tangent may be than the greatest entry that comes of it: the engine refuses
/// the tangent where such a sum is beyond all doubles. It depends on what cancels, and is not derived: where more does,
/// a refusal counts as a disagreement, and somebody has to look.
inline constexpr double kGreatestOnTheWay = 0x1p10;

/// Whether a tangent off by no more than that may be beyond all doubles, or a sum on the way to it: the engine may
/// refuse it then.
bool may_overflow(const reference::Tangent& truth, const fast::Tangent& allowed);

/// Holds the engine's tangent against the oracle's, every entry within what is allowed; widths are told block by block.
void check_tangent(const fast::Contact& subj, const reference::Tangent& truth, const fast::Tangent& allowed,
                   Checks& checks);

}  // namespace pcm::compare
