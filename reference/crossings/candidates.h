// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "reference/pose/box_tree.h"

/// Which pairs are worth an exact look: boxes are closed, so that none is missed whose features they hold.
namespace pcm::reference {

using IndexPair = std::pair<Index, Index>;

/// All pairs (i, j) whose boxes, i of `a` and j of `b`, have a point in common: ascending.
std::vector<IndexPair> meeting_boxes(const BoxTree& a, const BoxTree& b);

}  // namespace pcm::reference
