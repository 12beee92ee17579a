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

/// Computes the positions of all crossings: edge meets face plane; at a degenerate crossing, where the edge lies in
/// the plane, the midpoint of closed edge and closed face. Off by a few ulps of the face and edge sizes over the sine
/// of the angle between them.
void locate_crossings(Workspace::Data& workspace);

}  // namespace pcm::fast
