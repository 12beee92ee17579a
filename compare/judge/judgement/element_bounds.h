// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/judge/lines/given_answer.h"
#include "compare/verify/bounds/question.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// How far a right engine's elements, force and torque may be from the oracle's on the same rounded problem, as far as
/// the elements that an answer lists tell it: the bounds of `pcm verify` for either scheme (rounding_bounds.h,
/// clipped_bounds.h).
struct ElementsHeld {
  struct Common {
    const GivenElement* given = nullptr;
    const reference::Element* truth = nullptr;
    double area_bound = 0;         ///< m^2
    double penetration_bound = 0;  ///< m
  };
  std::vector<Common> common;                      ///< elements that both sides have
  std::vector<const reference::Element*> missing;  ///< that the answer may not be without
  std::vector<const GivenElement*> spurious;       ///< that it may not have
  double force_bound = 0;                          ///< N
  double torque_bound = 0;                         ///< N m
};

/// Barycentric elements are discrete facts. Of the clipped ones slivers may come and go: elements no larger than what
/// roundings may make of their outline. Those that the answer alone has enter force and torque with the most that its
/// own area and penetration carry. Where an answer lists no elements, it is taken to have none of its own. Both lists
/// must outlive what is returned.
ElementsHeld hold_elements(const Question& question, const std::vector<GivenElement>& given,
                           const reference::Answer& truth);

}  // namespace pcm::compare
