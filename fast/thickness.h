// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fast/surface.h"

namespace pcm::fast {

/// How far a face's penetration line may be off, relative to the surface's reach, with its thickness still a lower
/// bound: the filter allows for poses that are rounded up to this.
inline constexpr double kThicknessTolerance = 0x1p-30;

/// For each face a lower bound of the distance from its barycentre along its inward normal to the next face of the same
/// surface, m; infinite where there is none (PCM section 6). It holds for every line off the true one by less than
/// kThicknessTolerance times the reach, 0 where that can't be told. It serves as a filter only: a penetration below it
/// needs no search of the master's own faces. O(n log n).
std::vector<double> lower_bounds_of_thickness(const Surface::Data& surface);

}  // namespace pcm::fast
