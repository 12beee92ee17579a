// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compare/judge/judgement/fact.h"
#include "compare/judge/judgement/tolerances.h"
#include "compare/judge/lines/given_answer.h"
#include "compare/verify/bounds/question.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// One fact of an answer held against one answer of the oracle.
struct FactJudged {
  Fact fact = Fact::touching;
  bool right = false;
  std::string text;  ///< where wrong: what each side says
  /// Of a set: what the oracle alone has, and what the engine alone has.
  std::int64_t lost = 0, spurious = 0;
};

/// Whether the answer says it, of one surface at least, or of all its elements, of which there may be none.
bool gives(const GivenAnswer& given, Fact fact);

/// The facts that an answer gives and that can be judged, in the order of Fact. `truth` must have been asked for as
/// `wanted_for` says. Not judged is what was not given, and what has no truth:
/// - a volume where a surface is open or the answer ambiguous; an area where an open border ends within a face;
/// - in the clipped scheme, where slivers may come and go, a mere number of elements, and elements without areas;
/// - area and penetration of elements where there are none that both sides have;
/// - a value of which doubles can tell nothing (its bound is infinite).
std::vector<FactJudged> judge_facts(const Question& question, const GivenAnswer& given, const reference::Answer& truth,
                                    const Tolerances& tolerances);

}  // namespace pcm::compare
