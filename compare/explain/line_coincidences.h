// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/explain/coincidence.h"
#include "reference/pose/exact_pose.h"

namespace pcm::compare {

/// What the penetration lines of these faces of the master (PCM section 6, barycentric scheme) pass at most `width`
/// away, no farther along than the first face of the slave that they meet, its border included: vertices and edges of
/// the slave, faces in which they lie; and faces of the slave on which their barycentres lie. In no particular order.
std::vector<Coincidence> line_coincidences(const reference::ExactPose& pose, Side master,
                                           const std::vector<Index>& faces, double width);

}  // namespace pcm::compare
