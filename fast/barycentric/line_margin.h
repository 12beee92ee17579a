// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fast/base/geometry.h"
#include "fast/predicates/penetration_predicates.h"
#include "fast/search/line_walk.h"
#include "fast/surface/clearance.h"

namespace pcm::fast {

/// How the slave moves, seen from a master's penetration lines, while points of F travel.
struct LineMotion {
  double way_over_travel = 1;  ///< of the slave's points near a line, at most
  double turning_radius = 1;   ///< travel over turn, at least, of rotations; m
};

/// A line that surely leaves the slave's body through the slave's face f, and that certificates decide.
struct DecidedLine {
  LineCoordinates coordinates;
  FaceGeometry geometry;  ///< of the master's face
  FacePoints f_Me;
  /// At a distance greater than 0, with nothing met before; else behind, with nothing met at all.
  bool element = false;
  double distance_error = 0;  ///< m
  // The certificates:
  Clearance clearance{};         ///< of f
  double greatest_of_slave = 0;  ///< its unit, m
  double thickness = 0;          ///< of the master's face, m
  double slave_free = 0;         ///< see ElementLanes,
  double slave_free_travel = 0;  ///< while F travels by so much, m
};

/// How far points of F may travel, m, until such a line may find something else; 0 where that can't be told. What is
/// found is exact in the rounded problem, there as here.
///
/// Seen from the line, points of the slave move by w. It passes through f while w is less than its distance from f's
/// sides, seen along it: until then none of them comes to lie on it. f's point on the line was one of f's plane as it
/// was, no farther than w from there: so the distance at which the line meets f, h over the cosine of its angle with
/// f's normal where its origin lies h beneath that plane, changes by w over that cosine at most. The cosine itself
/// changes by no more than the slave turns, and h, beneath the plane as it is then, by w and that times the distance.
/// Roundings of small faces turn normals as well, by less than the cones of fast/surface/clearance.cpp are wider than
/// they say.
double travel_until_undecided(const DecidedLine& line, const LineMotion& motion);

}  // namespace pcm::fast
