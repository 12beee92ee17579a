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
  SurePlane plane(f.points_Me);
  std::array<double, 3> heights;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& shared = f.projected.vertices;
    const bool is_corner = f.projected.of_master == g.projected.of_master &&
                           std::find(shared.begin(), shared.end(), g.projected.vertices[k]) != shared.end();
    heights[k] = is_corner ? 0 : plane.height(g.points_Me[k], work);
  }
  const double greatest = std::max({std::abs(heights[0]), std::abs(heights[1]), std::abs(heights[2])});
  if (greatest > 0 && greatest < kUnderflown) return plane.scaled_heights(g.points_Me).value;
  return heights;
}

namespace {

/// 1: all above or in the plane, -1: below or in it, 0: all in it, 2: on both sides.
int side_of_plane(const std::array<double, 3>& heights) {
  const bool above = std::max({heights[0], heights[1], heights[2]}) > 0;
  const bool below = std::min({heights[0], heights[1], heights[2]}) < 0;
  return above && below ? 2 : above ? 1 : below ? -1 : 0;
}

}  // namespace

Order order_of(const PlacedFace& g, const PlacedFace& f, std::array<double, 3>& f_over_g, WorkCounters& work) {
  const int side_of_g = side_of_plane(heights_over(f, g, work));
  if (side_of_g == 0) {
    return !g.projected.of_master && g.projected.face < f.projected.face ? Order::before : Order::after;
  }
  if (side_of_g != 2) return side_of_g > 0 ? Order::before : Order::after;
  f_over_g = heights_over(g, f, work);
  const int side_of_f = side_of_plane(f_over_g);
  if (side_of_f != 2) return side_of_f > 0 ? Order::after : Order::before;
  return Order::crossing;
}

bool meet_in_line(const std::array<double, 3>& heights) {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  return (*low < 0 && *high > 0) || std::count(heights.begin(), heights.end(), 0.0) == 2;
}

}  // namespace pcm::fast
