// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/published/triangle_segment.h"

#include <Eigen/Geometry>
#include <utility>

namespace pcm::compare::published {
namespace {

/// Heights of a triangle's vertices over the plane of another, times |N|; false where they are all on one side.
bool straddles(const PosedFace& triangle, const PosedFace& plane, std::array<double, 3>& height) {
  int above = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    height[k] = plane.N_Me.dot(triangle.points_Me[k] - plane.points_Me[0]);
    above += height[k] >= 0;
  }
  return above == 1 || above == 2;
}

/// The two edges of a straddling triangle that pass through the plane, the one with the smaller coordinate along `axis`
/// first.
std::array<Crossing, 2> cut(const Surface& surface, Side side, Index face, const PosedFace& triangle,
                            const std::array<double, 3>& height, Index plane, int axis) {
  std::array<Crossing, 2> cuts;
  std::size_t found = 0;
  const Triangle& corners = surface.face(face);
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t a = k, b = (k + 1) % 3;
    if ((height[a] >= 0) == (height[b] >= 0)) continue;
    if (corners[a] > corners[b]) std::swap(a, b);
    Crossing& crossing = cuts[found++];
    crossing.along = height[a] / (height[a] - height[b]);
    crossing.position_Me = triangle.points_Me[a] + crossing.along * (triangle.points_Me[b] - triangle.points_Me[a]);
    crossing.edge = surface.face_edges[static_cast<std::size_t>(face)][k];
    crossing.face = plane;
    crossing.edge_side = side;
    crossing.first_end_below = height[a] < 0;
  }
  if (cuts[0].position_Me[axis] > cuts[1].position_Me[axis]) std::swap(cuts[0], cuts[1]);
  return cuts;
}

}  // namespace

std::optional<Segment> intersect(const Surface& surface_E, Index e, const PosedFace& face_E, const Surface& surface_F,
                                 Index f, const PosedFace& face_F) {
  std::array<double, 3> height_E, height_F;
  if (!straddles(face_E, face_F, height_E) || !straddles(face_F, face_E, height_F)) return {};
  const Eigen::Vector3d direction = face_E.N_Me.cross(face_F.N_Me);
  // Along the coordinate that the line changes most, points on it are in the order of that coordinate.
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  const std::array<Crossing, 2> on_E = cut(surface_E, Side::E, e, face_E, height_E, f, axis);
  const std::array<Crossing, 2> on_F = cut(surface_F, Side::F, f, face_F, height_F, e, axis);
  const auto later = [axis](const Crossing& a, const Crossing& b) { return a.position_Me[axis] > b.position_Me[axis]; };
  const Crossing& first = later(on_E[0], on_F[0]) ? on_E[0] : on_F[0];
  const Crossing& last = later(on_E[1], on_F[1]) ? on_F[1] : on_E[1];
  if (later(first, last)) return {};
  Segment segment{{first, last}, e, f, false};
  if (direction[axis] < 0) std::swap(segment.ends[0], segment.ends[1]);
  return segment;
}

}  // namespace pcm::compare::published
