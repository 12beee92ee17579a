// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fast/posed/posed_pair.h"

namespace pcm::fast {

/// The winding number of the other surface, which is closed, about vertex v of `side`: exact on the rounded problem,
/// tie rule included. Counts the faces that the segment from v to a point outside the other surface passes through;
/// that point is one more vertex, last in the order of the tie rule, so it changes no other sign. Near O(log n).
/// `open` is scratch.
Index winding_about_vertex(PosedPair& posed, Side side, Index v, std::vector<Index>& open);

}  // namespace pcm::fast
