// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// The face pairs of the surface that intersect each other, by the numbers of an OBJ file, in words without a line
/// feed; empty where there is none. Indices must be in range, coordinates finite, and no face may repeat a vertex.
/// Cost: about that of reading the file.
std::string self_intersection_warning(const TriangleMesh& mesh);

/// What is odd about a surface although it is fit for contact: "warning: NAME: ..." in one line, with the warnings of
/// check() and the one above; empty where nothing is odd. Throws BadInput where the surface is unfit, as require_fit.
std::string require_fit_or_warn(const TriangleMesh& mesh);

/// Prints the warnings on both surfaces of a pairing on standard error, the same one once only.
void print_warnings(const std::string& warning_E, const std::string& warning_F);

}  // namespace pcm::compare
