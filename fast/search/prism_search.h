// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fast/posed/posed_pair.h"
#include "fast/prism/master_prism.h"

namespace pcm::fast {

/// How far off the prism's lines may be wherever any surface reaches, and so depths: no point is farther from p0 than 4
/// times the greatest coordinate, m.
inline double farthest_off(const MasterPrism& prism, const Placement& placement) {
  return prism.tilt() * (4 * placement.max_coordinate);
}

/// The prism in the frame of a side's tree, so wide that no roundings of the side's vertices and of the prism's lines
/// put a face that they meet outside; wider by `wider_by`, m.
TreePrism prism_in_tree(const PosedPair& posed, Side side, const MasterPrism& prism, double wider_by = 0);

/// Lists all faces of a side that the prism may meet at a depth from 0 to `deepest`, and some that lie near it,
/// ascending. Near O(log n + faces listed). `open` is scratch.
void list_faces_in_prism(PosedPair& posed, Side side, const TreePrism& prism, double deepest, std::vector<Index>& open,
                         std::vector<Index>& faces);

}  // namespace pcm::fast
