// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "compare/explain/coincidence.h"
#include "reference/pose/surface.h"

/// What a feature of a surface belongs to.
namespace pcm::compare {

/// The faces at a vertex or at an edge; a face itself.
std::vector<Index> faces_at(const reference::Surface& surface, const Feature& feature);

/// The ends of the edges at a vertex, ascending; of an edge itself; none of a face.
std::vector<std::array<Index, 2>> edges_at(const reference::Surface& surface, const Feature& feature);

}  // namespace pcm::compare
