// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/base/geometry.h"
#include "fast/prism/ray.h"
#include "fast/surface/prepared_surface.h"

namespace pcm::fast {

/// How far a face's penetration line may be off, relative to the surface's greatest coordinate, with its thickness
/// still a lower bound: the filter allows for poses that are rounded up to this.
inline constexpr double kThicknessTolerance = 0x1p-30;

/// Of a face's area times kThicknessTolerance of the greatest coordinate, m^3. Heights over a face times its area are
/// rounded to multiples of 2^-1074 m^3: above this that is no more of a depth than 2^-53 of that tolerance.
inline constexpr double kLeastVolume = 0x1p-1021;

double lower_bound_of_thickness(const PreparedSurface& surface, Index face);
ThicknessEverywhere lower_bounds_of_thickness_everywhere(const PreparedSurface& surface, Index face);

/// A lower bound of the distance from the face's barycentre along its inward normal to the next face of the same
/// surface, m; infinite where there is none (PCM section 6). It holds for every line off the computed ray by less than
/// kThicknessTolerance times the greatest coordinate (thickness_holds tells of which), 0 where that can't be told. It
/// serves as a filter only: a penetration below it needs no search of the master's own faces. Computed when first asked
/// for, in O(log n) where the surface is well shaped.
inline double thickness(const PreparedSurface& surface, Index face) {
  return surface.known_thickness.get(face, [&] { return lower_bound_of_thickness(surface, face); });
}

/// Lower bounds of the same distance over all points of the face. Computed when first asked for.
inline ThicknessEverywhere thickness_everywhere(const PreparedSurface& surface, Index face) {
  return surface.known_thickness_everywhere.get(face,
                                                [&] { return lower_bounds_of_thickness_everywhere(surface, face); });
}

/// Whether the bounds of a face hold for it as a pose has placed it. Its vertices are where the pose takes them but for
/// `vertex_error`, m, which turns its normal by at most that times two of its edges over its area: on the body the line
/// is off by no more than 3.47 times its greatest coordinate M times this, for no two of its points are farther apart.
/// What the factor 8 has to spare is 5 `vertex_error` at least, as edges over area exceed 1.15 / M; it pays for the
/// other faces' vertices, and for lengths in Mf that are not quite those in Me. Never where heights over the face times
/// its area may underflow.
inline bool thickness_holds(const PreparedSurface& surface, double vertex_error, const FaceGeometry& face) {
  const Ray ray(face, face.points_Me[0]);
  const auto& p = face.points_Me;
  const double edges = (p[1] - p[0]).lpNorm<1>() + (p[2] - p[0]).lpNorm<1>();
  const double max_coordinate = surface.max_coordinates.maxCoeff();
  const double line_error =
      vertex_error + 8 * max_coordinate * (ray.direction_error + vertex_error * edges / face.area);
  const double tolerance = kThicknessTolerance * max_coordinate;
  return line_error < tolerance && face.area * tolerance > kLeastVolume;
}

}  // namespace pcm::fast
