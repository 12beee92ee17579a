// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/explain/coincidence.h"
#include "reference/pose/exact_pose.h"

namespace pcm::compare {

/// Which of these places belong together, along an edge or over a face: an edge of each with two places in common is
/// one along the other, an edge with two of a face lies in it, faces with three lie in one plane. Places count as two
/// where both are exact, which makes them different ones, or where they are more than 2 `width` apart.
std::vector<Coincidence> joined_features(const reference::ExactPose& pose, const std::vector<Coincidence>& places,
                                         double width);

}  // namespace pcm::compare
