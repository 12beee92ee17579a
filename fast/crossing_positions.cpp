// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fast/crossings.h"

namespace pcm::fast {

namespace {

/// The midpoint of the part of the segment (a, b) that lies in the face (p, q, s), all in one plane with normal N; a
/// point of the segment where they do not meet.
Eigen::Vector3d midpoint_in_plane(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const std::array<Eigen::Vector3d, 3>& face, const Eigen::Vector3d& N) {
  int drop = 0;
  N.cwiseAbs().maxCoeff(&drop);
  const int i = (drop + 1) % 3, j = (drop + 2) % 3;
  const double winding = N[drop] < 0 ? -1 : 1;
  double first = 0, last = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d& p = face[k];
    const Eigen::Vector3d side = face[(k + 1) % 3] - p;
    const auto height = [&](const Eigen::Vector3d& x) {
      return winding * (side[i] * (x[j] - p[j]) - side[j] * (x[i] - p[i]));
    };
    const double at_a = height(a), at_b = height(b);
    if (at_a < 0 && at_b > at_a) first = std::max(first, std::min(1.0, at_a / (at_a - at_b)));
    if (at_b < 0 && at_a > at_b) last = std::min(last, std::max(0.0, at_a / (at_a - at_b)));
  }
  return a + (0.5 * (first + last)) * (b - a);
}

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
  // A height of the wrong sign is rounding: the end lies in the plane as far as floating point can tell.
  if (at_a == 0 && at_b == 0) {
    const bool in_plane = exact_orientation(p.data(), q.data(), s.data(), a.data()) == 0 &&
                          exact_orientation(p.data(), q.data(), s.data(), b.data()) == 0;
    return in_plane || N.isZero(0) ? midpoint_in_plane(a, b, {p, q, s}, N) : Eigen::Vector3d(a + 0.5 * (b - a));
  }
  const double sum = at_a + at_b;
  if (!std::isfinite(sum)) return a + 0.5 * (b - a);
  // From the nearer end, so that a point close to it is as exact as that end.
  return at_a <= at_b ? Eigen::Vector3d(a + (at_a / sum) * (b - a)) : Eigen::Vector3d(b + (at_b / sum) * (a - b));
}

}  // namespace

void locate_crossings(Workspace::Data& workspace) {
  WorkCounters& work = workspace.contact.work;
  for (CrossingNode& crossing : workspace.crossings) {
    PosedSurface& edges = workspace.side(crossing.edge_side).posed;
    PosedSurface& faces = workspace.side(opposite(crossing.edge_side)).posed;
    const std::array<Index, 2>& ends = edges.surface().edge(crossing.edge);
    const Triangle& corners = faces.surface().face(crossing.face);
    crossing.position_Me = edge_meets_face(edges.vertex_Me(ends[0], work), edges.vertex_Me(ends[1], work),
                                           faces.vertex_Me(corners[0], work), faces.vertex_Me(corners[1], work),
                                           faces.vertex_Me(corners[2], work), crossing.from_above);
  }
}

}  // namespace pcm::fast
