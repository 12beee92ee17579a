// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/verify/bounds/question.h"
#include "compare/verify/verdict/checks.h"
#include "pcm/contact.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// Holds the engine's tangent against the oracle's of the rounded problem, every entry within its bound
/// (tangent_bounds.h); widths are told block by block. `true_rounded` has the oracle's elements, `found` are the
/// engine's: where it alone has one, a sliver, nothing is known.
void check_tangent(const Question& question, const fast::Contact& subj, const std::vector<fast::Element>& found,
                   const reference::Answer& true_rounded, const reference::Tangent& truth, Checks& checks);

}  // namespace pcm::compare
