// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A closed surface that lines leave which never entered it.
#pragma once

#include "meshes/generate/degenerate/hard_bodies.h"
#include "tests/meshes/transformed_meshes.h"

namespace pcm::reference {

/// Two prisms along z in one, of which the smaller, on the left, is inside out. Its winding number is -1 in the
/// triangle (x - 2, -2), (x, 0), (x - 2, 2), and 1 in (x, 0), (x + 4, -4), (x + 4, 4).
inline TriangleMesh bow_tie(double x) {
  return translated(degenerate::prism_over({{4, -4}, {4, 4}, {-2, -2}, {-2, 2}}, {1, 0}, 8), {x, 0, 0});
}

}  // namespace pcm::reference
