// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "compare/explain/coincidence.h"
#include "compare/explain/sign.h"
#include "pcm/work_counters.h"
#include "reference/pose/exact_pose.h"

/// The signs that depend on a coincidence, and who decides them.
namespace pcm::compare {

/// Of a coincidence: of each vertex with each face at its partner; of two edges; of a penetration line with each edge
/// at what it passes through. Of coplanar faces: of the vertices of each with the other.
std::vector<Sign> signs_of(const reference::ExactPose& pose, const Coincidence& coincidence);

/// The stage that a predicate of the engine, the only one counted, took last.
Stage stage_of(const fast::WorkCounters& work);

/// Of four vertices, with the engine's predicate for the stage and the oracle's numbers for the term.
Sign orientation_sign(const reference::ExactPose& pose, const std::array<reference::Vertex, 4>& vertices);

}  // namespace pcm::compare
