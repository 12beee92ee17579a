// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "fast/clipped/placed_face.h"
#include "fast/prism/master_prism.h"

namespace pcm::fast {

/// How far what a master face is found to see may be from the rounded problem, whose vertices are given (PCM section
/// 1). Which of two faces lies before the other, wherever their order is one, and what is met at depth 0 is decided
/// exactly; only places are rounded. With u = 2^-53, S the greatest |coordinate| of E, F, A x_F and r, so that no two
/// points of bodies that touch are farther apart than D = 3 sqrt(3) S, no edge is longer than 2 sqrt(3) S, and
/// Placement::max_coordinate is no more than (1 + sqrt(3)) S, and q = |p1 - p0| |p2 - p0| / |N| of the master face,
/// lengths being sums of |components|:
///
/// Places. A weight has 4 roundings, its gradient 8: with errors of s and t apart, a corner is off by 2 q 12 u D in the
/// plane, at most 125 q u S, and by the lines' direction, 4 u (1 + q), at most 42 q u S more. The four cuts that shape
/// a projected face round by 3 u of segments up to 2 q D long, together 125 q u S; a half plane's value at a point by
/// 42 q u S; each further cut, within the master, by 10 q u S. Strips that are dropped or kept though they are not
/// certain are no wider than the uncertainty of s and t, 64 u (1 + sqrt(3)) S each: 350 q u S. With no more than 34
/// further cuts that is delta = kPlaceRoundings q u S.
///
/// Depths. A height has kFilterRelative of its terms, which is 47 q u S of depth, the lines' direction and the four
/// cuts add 84 q u S, and being off in place adds tan theta times 292 q u S, theta the angle between the planes of the
/// face and of the master: 131 + 292 tan theta <= sqrt(131^2 + 292^2) / cos theta, so that this is no more than epsilon
/// = 321 q u S / cos theta.
///
/// Lines that part what is seen, each off by
///   - a projected edge: delta;
///   - where f and g have one depth, or g has depth 0 (f the master), their planes at an angle a: delta
///     + min(642 q u S / sin a, 2 kHeightError S). For |grad (d_f - d_g)| >= sin a / min(cos theta_f, cos
///     theta_g); and between its corners' sure heights a line is off by no more than kHeightError / 2 of an edge.
///
/// So of an element {e, f} with the outline P of what e sees of f (in any number of convex pieces), its sides as long
/// as l_i and off by delta_i, meeting at angles b_ij, the area is off by no more than
///     sum l_i delta_i + sum (delta_i + delta_j) min((delta_i + delta_j) / sin b_ij, |p1 - p0| + |p2 - p0|)
///     + 4 delta^2 / cos theta_f,
/// nor by more than what e and f's projection have in common; the integral of the depth by each of these terms times
/// the greatest depth near it, and by area times epsilon. An element that only one of them has is no greater than the
/// strips along the outlines of its master face's elements, and of the face itself. A force of the clipped scheme is
/// off by the sum over the elements times the stiffness, however many of them there are.
inline constexpr double kPlaceRoundings = 1024;

/// Pieces no wider than this share of what makes a face certain are dropped where faces are cut by others: about as
/// wide as one rounding of a distance makes slivers along a line that several faces share. What is wider may be seen.
inline constexpr double kSliver = 1.0 / 16;

/// Where a face overlaps another one: a face that leaves the slave, and one that may lie before it.
using Overlap = std::pair<std::size_t, std::size_t>;

/// What the search for overlaps reads of all faces; the faces themselves are large.
struct FaceExtent {
  double low_s, high_s, low_t, high_t;
  std::size_t index;  ///< of the face
  bool carries;
};

/// Finds all overlaps among the faces of positive area, ordered by first, then second; the first is always a face of
/// the slave through which it is left. `by_low_s` is scratch. Sweeps along s: O(n log n) plus the pairs that overlap
/// there.
void find_overlaps(const std::vector<ProjectedFace>& faces, std::vector<FaceExtent>& by_low_s,
                   std::vector<Overlap>& overlaps);

/// What was done to the pieces of a face, convex polygons, that is not exact but for roundings of its own points.
struct ClippingError {
  double area = 0;  ///< dropped, or kept though hidden, in (s, t)
  /// Of the pieces that are left: how many, and what the cuts that part them from the whole may change.
  int pieces = 0;
  int cuts = 0;  ///< the greatest number of them that one piece has seen
  double cut_area = 0;
  double cut_volume = 0;  ///< integral of the depth there, m

  /// A cut of the whole by other faces puts vertices, whose coordinates are no greater than 1, off by 2 u times the
  /// whole's width and u. The integrals are off by as much as a shift by 10 u times the piece's width would make.
  void add_piece(const ConvexPolygon& piece, const ConvexPolygon& whole);
};

/// Takes from `pieces` of the face f, through which the lines leave the slave, what they reach only after g: where g is
/// met at a depth >= 0 and not farther than f (PCM section 6). Where the two planes are one, the face of smaller index
/// is before the other one of the slave, and none of the master is before any of the slave. Which of two faces lies
/// before the other is decided exactly where the plane of one has the other on one side, as it has wherever faces share
/// a vertex and wherever they do not intersect; the part taken is exact but for roundings.
///
/// Slivers are dropped (kSliver), and a piece of which g hides no more than a sliver is not split: it loses that strip
/// where one piece remains, and stays whole where more would. Both change only strips along the borders
/// of f and g, as wide as these are uncertain. So the pieces, which do not overlap, have areas, and are cells between
/// the sides of those faces that certainly hide some of f: with n of them at most of the order of n^2, and of n where
/// each meets few of the pieces the others leave; `clipping_error` counts both. Without that, slivers of rounding size
/// along one line (faces that the lines run in, several at one border) would cut each other to pieces without end.
/// `remaining` is scratch.
void subtract_hidden(const PlacedFace& f, const PlacedFace& g, std::vector<ConvexPolygon>& pieces,
                     std::vector<ConvexPolygon>& remaining, ClippingError& clipping_error, WorkCounters& work);

}  // namespace pcm::fast
