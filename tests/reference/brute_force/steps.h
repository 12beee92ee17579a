// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "tests/reference/brute_force/answer.h"

/// The steps of the twin, each filling its part of the answer.
namespace pcm::brute_force {

/// What the steps pass on.
struct Steps {
  std::map<Crossing, int>
      passages;  ///< every crossing, +1 where the edge, from its first vertex, goes from above to below
  /// Segment of each crossing face pair (face of E, face of F): start and end in the circulation (5).
  std::map<std::array<Index, 2>, std::array<Crossing, 2>> segments;
  std::array<std::vector<bool>, 2> intersected;     ///< by side and face
  std::array<std::vector<bool>, 2> vertex_inside;   ///< by side and vertex, as patches need it
  std::array<std::vector<bool>, 2> vertex_outside;  ///< labelled outside by an edge or a set (open other surface)
  std::array<std::vector<int>, 2> winding;          ///< by side and vertex; closed other surface only
  std::array<std::vector<bool>, 2> active;          ///< intersected or inner, by side and face
};

inline int index_of(Side side) {
  return side == Side::E ? 0 : 1;
}

void find_crossings(Answer& answer, Steps& steps);
void chain_polygons(Answer& answer, const Steps& steps);
void find_inner_faces(Answer& answer, Steps& steps);
void find_patches(Answer& answer, const Steps& steps);
void clip_by_prisms(Answer& answer);
void sweep_perturbed_areas(Answer& answer, const Steps& steps);
void sum_areas(Answer& answer);
void find_elements(Answer& answer, const Steps& steps, Mode mode);

/// Replaces the elements by those of the clipped scheme, clamped to max_penetration, m.
void find_clipped_elements(Answer& answer, Mode mode, double max_penetration);

/// Signed sum of the passages along the directed edge a -> b: the change of the winding number.
int change_along(const Steps& steps, Side side, Index a, Index b);

/// A convex polygon cut by the half-space gradient . x >= level; one that lies in the boundary plane is kept where
/// `inward` points into the half-space.
std::vector<Vector> clipped(const std::vector<Vector>& polygon, const Vector& gradient, const Rational& level,
                            const Vector& inward);

/// Area of a convex polygon in the plane of a face with normal N, as a fraction of the face's area, and its moment.
struct Measure {
  Rational fraction = 0;
  Vector moment{};
};
Measure measure(const std::vector<Vector>& polygon, const Vector& normal);

}  // namespace pcm::brute_force
