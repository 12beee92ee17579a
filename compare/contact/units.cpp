// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contact/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "compare/poses/greatest_extent.h"

namespace pcm::compare {

void scale(TriangleMesh& mesh, double metres_per_unit) {
  for (Eigen::Vector3d& x : mesh.vertices) x *= metres_per_unit;
}

std::string millimetre_remark(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, const LayerThickness& thickness) {
  const double extent_E = greatest_extent(mesh_E), extent_F = greatest_extent(mesh_F);
  constexpr const char* kMend = "if the files are in millimetres, add --scale 0.001, if in metres, --scale 1";
  if (std::min(extent_E, extent_F) >= kLargestPart)
    return fmt::format("the surfaces are {:.3g} m and {:.3g} m large; {}", extent_E, extent_F, kMend);
  for (const auto& [name, size, layer] :
       {std::tuple("E", extent_E, thickness.E), std::tuple("F", extent_F, thickness.F)})
    if (layer && size >= kThinnestLayer * *layer)
      return fmt::format("surface {} is {:.3g} m large and its layer {:.3g} m thick; {}", name, size, *layer, kMend);
  return {};
}

}  // namespace pcm::compare
