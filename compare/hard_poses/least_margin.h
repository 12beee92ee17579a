// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/poses/strata.h"

namespace pcm::compare {

/// The least margin above 0 of all orientations of a face of one body and a vertex of the other, and of an edge of each
/// (orientation_margin.h); infinite where there is none. Of the rounded problem.
/// Cost: O(n m), 10 ns for most of them and 1 us for those that may be the least.
double least_margin(const FeaturePair& pair, const Pose& pose);

}  // namespace pcm::compare
