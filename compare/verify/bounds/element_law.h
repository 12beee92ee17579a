// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/verify/bounds/question.h"
#include "reference/vocabulary/answer.h"

/// The contact law once more, in plain doubles, for elements that the oracle does not have (PCM section 7).
namespace pcm::compare {

/// c_l (12).
double series_stiffness(const ContactLaw& law);

/// Which part of its penetration an element lies from its master face towards the slave (13): c_F / (c_E + c_F) for
/// master E. 2 roundings.
double share_of_penetration(const ContactLaw& law, Side master);

/// The element with the velocities (16), (17), (19) and forces (14), (15), (18), (20), (21) that its area, penetration,
/// unit normal and position make. Each is a straightforward evaluation, so off by no more than bounds_after_law of no
/// geometry errors.
reference::Element after_law(const Question& question, reference::Element element);

}  // namespace pcm::compare
