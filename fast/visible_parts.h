// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fast/projected_face.h"

namespace pcm::fast {

/// A face in the prism together with its vertices in Me.
struct PlacedFace {
  const ProjectedFace& projected;
  std::array<Eigen::Vector3d, 3> points_Me;  ///< of `projected.vertices`, so counterclockwise as the master sees them
};

/// What was done to the parts of a face that is not exact but for roundings of its own points.
struct Neglect {
  double area = 0;  ///< dropped, or kept though hidden, in (s, t)
  /// Of the parts that are left: how many, and what the cuts that part them from the whole may change.
  int parts = 0;
  int cuts = 0;  ///< the greatest number of them that one part has seen
  double cut_area = 0;
  double cut_volume = 0;  ///< integral of the depth there, m

  /// A cut of the whole by other faces puts vertices, whose coordinates are no greater than 1, off by 2 u times the
  /// whole's width and u. The integrals are off by as much as a shift by 10 u times the part's width would make.
  void add_part(const ConvexPolygon& part, const ConvexPolygon& whole);
};

/// Takes from `parts` of the face f, through which the lines leave the slave, what they reach only after g: where g is
/// met at a depth >= 0 and not farther than f (PCM section 6). Where the two planes are one, the face of smaller index
/// is before the other one of the slave, and none of the master is before any of the slave. Which of two faces lies
/// before the other is decided exactly where the plane of one has the other on one side, as it has wherever faces share
/// a vertex and wherever they do not intersect; the part taken is exact but for roundings.
///
/// Parts that are not certain to have area are dropped, and a part of which g hides nothing certain is not split: it
/// loses that strip where one part remains, and stays whole where more would. Both change only strips along the borders
/// of f and g, as wide as these are uncertain. So the parts, which do not overlap, have areas, and are cells between
/// the sides of those faces that certainly hide some of f: with n of them at most of the order of n^2, and of n where
/// each meets few of the parts the others leave; `neglect` counts both. Without that, slivers of rounding size along
/// one line (faces that the lines run in, several at one border) would cut each other to pieces without end.
/// `remaining` is scratch.
void subtract_hidden(const Uncertainty& uncertainty, const PlacedFace& f, const PlacedFace& g,
                     std::vector<ConvexPolygon>& parts, std::vector<ConvexPolygon>& remaining, Neglect& neglect,
                     WorkCounters& work);

}  // namespace pcm::fast
