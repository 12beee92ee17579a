// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/clipped/placed_face.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcm::fast {

PlacedFace placed_face(PosedPair& posed, Side master, const MasterPrism& prism, const ProjectedFace& face) {
  const Side side = face.of_master ? master : opposite(master);
  return {face,
          {posed.vertex_Me(side, face.vertices[0]), posed.vertex_Me(side, face.vertices[1]),
           posed.vertex_Me(side, face.vertices[2])},
          prism,
          posed.placement.max_coordinate};
}

std::array<double, 3> heights_over(const PlacedFace& f, const PlacedFace& g, WorkCounters& work) {
  std::array<double, 3> heights;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& shared = f.projected.vertices;
    const bool is_corner = f.projected.of_master == g.projected.of_master &&
                           std::find(shared.begin(), shared.end(), g.projected.vertices[k]) != shared.end();
    heights[k] = is_corner ? 0 : height_over(f.points_Me, g.points_Me[k], work);
  }
  const double greatest = std::max({std::abs(heights[0]), std::abs(heights[1]), std::abs(heights[2])});
  if (greatest > 0 && greatest < kUnderflown) return scaled_heights_over(f.points_Me, g.points_Me);
  return heights;
}

bool meet_in_line(const std::array<double, 3>& heights) {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  return (*low < 0 && *high > 0) || std::count(heights.begin(), heights.end(), 0.0) == 2;
}

}  // namespace pcm::fast
