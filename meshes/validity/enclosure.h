// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pcm/triangle_mesh.h"

namespace pcm {

/// For each closed component of a surface the number of other closed components that enclose it: even for an outer
/// shell, odd for a cavity.
///
/// A component is enclosed by another if none of its vertices lies strictly outside the other, at least one lies
/// strictly inside, and no edge of either passes through the inside of a face of the other; so bodies that touch, stand
/// on one another or cross, as a spoke crosses the rim that its ends lie in, aren't taken for nested ones. Inside is
/// decided by the parity of the faces above a vertex; all signs are exact, whatever the orientation of the faces.
///
/// `component_of_face[f]` is the closed component of face f, below `component_count`, or negative for a face to leave
/// out. The vertices of the others must be finite. Cost: about (F + V) sqrt(F) where components are nested; a vertex
/// each where they are apart.
std::vector<Index> count_enclosing_components(const TriangleMesh& mesh, const std::vector<Index>& component_of_face,
                                              Index component_count);

}  // namespace pcm
