// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fast/crossings/crossings.h"

namespace pcm::fast {

namespace {

/// Edge (a, b) meets the plane of (p, q, s); a is above it under the tie rule where `from_above`, b is not.
Eigen::Vector3d edge_meets_face(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p,
                                const Eigen::Vector3d& q, const Eigen::Vector3d& s, bool from_above) {
  const Eigen::Vector3d N = (q - p).cross(s - p);
  // Heights are taken from the nearest corner, whose difference carries the smallest error.
  const auto height = [&](const Eigen::Vector3d& x) {
    const Eigen::Vector3d d[3] = {x - p, x - q, x - s};
    const double squares[3] = {d[0].squaredNorm(), d[1].squaredNorm(), d[2].squaredNorm()};
    return N.dot(d[std::min_element(squares, squares + 3) - squares]);
  };
  const double sign = from_above ? 1 : -1;
  const double at_a = std::max(0.0, sign * height(a));
  const double at_b = std::max(0.0, -sign * height(b));
  // A height of the wrong sign is rounding. Where both are, the edge is as near the plane as floating point can tell.
  const double sum = at_a + at_b;
  if (sum == 0) return a + 0.5 * (b - a);
  // From the nearer end, so that a point close to it is as exact as that end.
  return at_a <= at_b ? Eigen::Vector3d(a + (at_a / sum) * (b - a)) : Eigen::Vector3d(b + (at_b / sum) * (a - b));
}

}  // namespace

void locate_crossings(PosedPair& posed, Crossings& crossings) {
  WorkCounters& work = posed.work;
  for (CrossingNode& crossing : crossings.nodes) {
    PosedSurface& edges = posed[crossing.edge_side];
    PosedSurface& faces = posed[opposite(crossing.edge_side)];
    const std::array<Index, 2>& ends = edges.surface().edge(crossing.edge);
    const Triangle& corners = faces.surface().face(crossing.face);
    crossing.position_Me = edge_meets_face(edges.vertex_Me(ends[0], work), edges.vertex_Me(ends[1], work),
                                           faces.vertex_Me(corners[0], work), faces.vertex_Me(corners[1], work),
                                           faces.vertex_Me(corners[2], work), crossing.from_above);
  }
}

}  // namespace pcm::fast
