// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/verify/bounds/question.h"
#include "compare/verify/verdict/checks.h"
#include "pcm/contact.h"

namespace pcm::compare {

/// Holds an answer against itself: counts, force, torque and statistics against its own elements, to the roundings of
/// sums of that many terms; the greatest penetration against theirs and, by the flag, the law's; and counters of work
/// against what the answer has. `subj` has everything but a bound.
void check_own_sums(const Question& question, const fast::Contact& subj, Checks& checks);

}  // namespace pcm::compare
