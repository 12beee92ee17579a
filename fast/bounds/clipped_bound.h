// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fast/bounds/clipped_error.h"
#include "fast/bounds/force_bound.h"
#include "fast/clipped/clipped_elements.h"

namespace pcm::fast {

/// Scratch memory of sum_bounded_clipped_elements.
struct ClippedBoundScratch {
  std::vector<Index> listed;  ///< faces near a master face's prism
  std::vector<Index> open;    ///< of the search for them
  ViewScratch sight;
  VisibleDepthScratch depth;
};

/// Forms the contact elements of the bound's master in the clipped scheme, as sum_clipped_elements does and to the same
/// bits: face by face, and from each face when it is formed reads the bound. `forming` is scratch.
///
/// The integrals of an element are off by what fast/bounds/clipped_error.h says, its force by what
/// fast/bounds/force_error.h makes of that, and the same for what the exact problem may have beside the computed
/// elements. A face of the master that is active in one problem only adds all it has and might have; `flipped` is set
/// where that is an element, where a face is seen flush, or where the master face is too narrow a needle: its normal is
/// not known, or its width not to 2^-6 of itself.
MasterForce sum_bounded_clipped_elements(const Intersection& intersection, const ForceProblem& problem,
                                         ClippedFaceScratch& forming, ClippedBoundScratch& scratch, MasterBound& bound,
                                         ElementRecord& record);

}  // namespace pcm::fast
