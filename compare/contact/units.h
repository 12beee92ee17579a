// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "pcm/triangle_mesh.h"

/// Files have no units of length: what is a metre there, and what is likely not one.
namespace pcm::compare {

/// All vertices times `metres_per_unit`, each rounded once. By 1, nothing changes.
void scale(TriangleMesh& mesh, double metres_per_unit);

/// Thickness b of the elastic layers (3), m, where it is known.
struct LayerThickness {
  std::optional<double> E, F;
};

/// The smaller surface's extent from which on lengths are likely millimetres, m: the parts of a machine are smaller, in
/// metres, and those above a centimetre larger, in millimetres. The larger surface may be the ground under a wheel.
inline constexpr double kLargestPart = 10;

/// Extent over thickness of a layer from which on they are. A layer stands for what of the body is compressed, a
/// hundredth of its extent or more; with the surface in millimetres and the layer in metres that is a thousand times
/// more, 1e3 to 1e5. Coatings are thin, so that the limit is not nearer to a hundred.
inline constexpr double kThinnestLayer = 1000;

/// What to look at where either limit is exceeded, in a line; empty where none is.
std::string millimetre_remark(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const LayerThickness& thickness);

}  // namespace pcm::compare
