// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fast/barycentric/penetration_line.h"
#include "fast/bounds/force_bound.h"

namespace pcm::fast {

/// Scratch memory of sum_bounded_barycentric_elements.
struct BarycentricBoundScratch {
  LineTrace line_trace;  ///< of the line at hand
  LineNodes line_open;
  std::vector<Index> open;
};

/// Forms the contact elements of the bound's master in the barycentric scheme, as sum_barycentric_elements does and to
/// the same bits, each with its bound.
///
/// A face whose decisions (is it active, which slave face does its line meet first, is q > 0, does no other face of the
/// master come before) are the same for all positions of F's vertices within their rounding adds the error of its
/// element, a running error analysis: fast/bounds/element_error.h, fast/bounds/force_error.h. Any other face may carry
/// an element in one problem and none, or another one, in the other: it adds what it has and what it might have at
/// most, and `flipped` is set. So do the faces that are not active in the rounded problem, but may be in the exact one.
MasterForce sum_bounded_barycentric_elements(const Intersection& intersection, const ForceProblem& problem,
                                             BarycentricBoundScratch& scratch, MasterBound& bound,
                                             ElementRecord& record);

}  // namespace pcm::fast
