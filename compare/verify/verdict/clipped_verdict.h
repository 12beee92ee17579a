// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/verify/bounds/element_law.h"
#include "compare/verify/bounds/question.h"
#include "compare/verify/verdict/checks.h"
#include "pcm/contact.h"
#include "reference/vocabulary/answer.h"

/// Contact elements one by one.
namespace pcm::compare {

/// Holds every number of an element that both sides have. `max_coordinate`: the greatest |coordinate|, in units of
/// which the widths of positions are told, m.
void check_element(const Question& question, const fast::Element& subj, const reference::Element& truth,
                   const ElementBounds& bound, double max_coordinate, Checks& checks);

/// How far the totals of the clipped scheme may be off; halved in mode `both`.
struct ClippedTotals {
  /// Between these lies a right engine's greatest penetration, m.
  double greatest_at_least = 0;
  double greatest_at_most = 0;
  double force = 0;   ///< N
  double torque = 0;  ///< N m
};

/// Holds the clipped scheme's elements: those of either side that are no slivers must be the other's as well, with all
/// their numbers. Both lists are in the order of masters, master faces, slave faces, each element once.
///
/// A sliver that the engine alone has must be no larger and no deeper than one may be, lie on its master face with that
/// face's normal, and carry what the law makes of its own area, penetration, normal and position.
ClippedTotals check_clipped_elements(const Question& question, const fast::Contact& subj,
                                     const reference::Answer& truth, Checks& checks);

/// Where a right engine's greatest penetration may lie outside its bounds for the exact problem's. Below them: where
/// all exact elements that reach as deep are slivers, which it need not have. Above: where it has a sliver, or keeps a
/// hidden strip of an element, that may reach as deep as it says; or by what roundings of its cuts leave beyond the
/// master's sides.
bool may_lie_outside(const Question& question, const fast::Contact& subj, const reference::Answer& true_rounded,
                     const reference::Answer& true_exact);

}  // namespace pcm::compare
