// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/explain/coincidence.h"
#include "reference/pose/exact_pose.h"

namespace pcm::compare {

/// All places at most `width` apart where a vertex, an edge or a face of E is near to one of F: a vertex to anything,
/// an edge across an edge. Of each pair the nearest points lie inside both (nearest_points.h), so every least distance
/// between the surfaces is among them. In no particular order. Near linear in the number of pairs of faces whose boxes
/// are as near.
std::vector<Coincidence> near_features(const reference::ExactPose& pose, double width);

}  // namespace pcm::compare
