// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "tests/reference/brute_force/answer.h"
#include "tests/reference/brute_force/elements.h"

/// The brute-force twin: the answer to a pose of two small surfaces (up to some 200 faces together) by trying
/// everything against everything over GMP rationals, in code and method of its own. It holds oracle and engine; nothing
/// holds it but the worked cases and the identities it is tested on.
///
/// - Ties: the determinant is evaluated as a polynomial in eps.
/// - Inside: a segment to a far point, against all faces.
/// - Clipped areas of closed surfaces: the winding number of F is the sum over its faces f of +-1 on the prism below f,
///   so a face's area inside F is a sum of convex clippings.
/// - Elements: the penetration line against all faces. Clipped scheme: the lines of sample points, one between any two
///   neighbours of all boundaries that matter, against all faces. Where the penetration is clamped is one more
///   boundary.
namespace pcm::brute_force {

/// Everything about one pose. Asserts what must hold of itself: two crossings a pair, one start and one end; the
/// winding number the same along two segments. `max_penetration` in m, of the clipped scheme only: elsewhere the
/// clamped u_k is that of q.
Answer answer(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const Pose& pose, reference::Problem problem,
              Mode mode = Mode::E, Scheme scheme = Scheme::barycentric,
              double max_penetration = std::numeric_limits<double>::infinity());

}  // namespace pcm::brute_force
