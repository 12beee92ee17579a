// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/judge/lines/given_answer.h"
#include "compare/poses/crossing_pairs.h"
#include "compare/verify/bounds/question.h"
#include "reference/vocabulary/answer.h"

/// Facts of the oracle's answer in the form in which answers give them.
namespace pcm::compare {

/// What the oracle has to work out for what an answer gives.
Wanted wanted_for(const GivenAnswer& answer);

/// Intersected and inner faces together, ascending.
std::vector<Index> active_faces(const std::vector<Index>& intersected, const std::vector<Index>& inner);

/// The pairs of faces that cross, ascending.
std::vector<FacePair> true_crossing_pairs(const Question& question, const reference::Answer& truth);

/// Whether both are alike in everything discrete: polygons as cycles, faces, elements.
bool same_discrete_facts(const reference::Answer& a, const reference::Answer& b);

}  // namespace pcm::compare
