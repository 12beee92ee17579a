// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/workspace.h"

namespace pcm::fast {

/// Finds all crossings (PCM section 4) and the segments between them: fills `crossings`, each once, with their
/// successors in the circulation of (5), and both sides' intersected faces, ascending. Exact on the rounded problem.
/// With `stop_at_first`, returns as soon as one crossing pair is known; with `keep_candidates`, fills `candidates` too;
/// not `filtered`, finds every sign by exact arithmetic. True where there is a crossing.
bool find_crossings(Workspace::Data& workspace, bool stop_at_first, bool keep_candidates, bool filtered);

/// Fills both sides' `edge_crossings`, each edge's list in the order of `order` (indices of crossings).
void list_crossings_by_edge(Workspace::Data& workspace);

/// Computes the positions of all crossings: edge meets face plane. No edge crosses a face in whose plane it lies, nor a
/// face without area: the tie rule moves all of E one way off such a plane, by more than anything of F. So positions
/// are where crossings tend to as the tie rule's move vanishes, and so are all areas made of them. Off by a few ulps of
/// the face and edge sizes over the sine of the angle between them.
void locate_crossings(Workspace::Data& workspace);

}  // namespace pcm::fast
