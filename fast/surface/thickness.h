// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fast/base/geometry.h"
#include "fast/prism/ray.h"
#include "fast/surface/prepared_surface.h"

namespace pcm::fast {

/// How far a face's penetration line may be off, relative to the surface's greatest coordinate, with its thickness
/// still a lower bound: the filter allows for poses that are rounded up to this.
inline constexpr double kThicknessTolerance = 0x1p-30;

/// For each face a lower bound of the distance from its barycentre along its inward normal to the next face of the same
/// surface, m; infinite where there is none (PCM section 6). It holds for every line off the true one by less than
/// kThicknessTolerance times the greatest coordinate, 0 where that can't be told. It serves as a filter only: a
/// penetration below it needs no search of the master's own faces. O(n log n).
std::vector<double> lower_bounds_of_thickness(const PreparedSurface& surface);

/// Lower bounds of the same distance over all points of each face. O(n log n).
ThicknessEverywhere lower_bounds_of_thickness_everywhere(const PreparedSurface& surface);

/// The faces beneath which no face that shares a vertex with them reaches, by more than the tolerance: at each of their
/// corners either all faces look their way, or each lies beside one of their sides. Not where a face stands upright.
/// O(n).
std::vector<bool> faces_clear_of_neighbours(const PreparedSurface& surface);

/// Whether the bounds of a face hold for it as a pose has placed it. Its vertices are where the pose takes them but for
/// `vertex_error`, m, which turns its normal by at most twice that over its edges' heights.
inline bool thickness_holds(const PreparedSurface& surface, double vertex_error, const FaceGeometry& face) {
  const Ray ray(face, face.points_Me[0]);
  const auto& p = face.points_Me;
  const double edges = (p[1] - p[0]).lpNorm<1>() + (p[2] - p[0]).lpNorm<1>();
  const double max_coordinate = surface.max_coordinates.maxCoeff();
  const double line_error =
      vertex_error + 8 * max_coordinate * (ray.direction_error + vertex_error * edges / face.area);
  return line_error < kThicknessTolerance * max_coordinate;
}

}  // namespace pcm::fast
