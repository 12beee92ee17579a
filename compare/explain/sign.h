// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "compare/explain/coincidence.h"

namespace pcm::compare {

enum class Predicate : std::uint8_t {
  orientation,         ///< ((b - a) x (c - a)) . (d - a) of four vertices (PCM section 4)
  side_of_line,        ///< D(C) = N_e . ((f_i - C) x (f_j - C)) of a penetration line and an edge (PCM section 6)
  facing,              ///< N_e . N_f of a penetration line and a face
  distance_along_line  ///< of q, from a barycentre along its penetration line to a face
};

/// Which stage of the engine's predicate is the last one that it takes.
enum class Stage : std::uint8_t {
  filter,    ///< floating point is sure
  exact,     ///< exact arithmetic, as floating point was not
  tie_rule,  ///< the exact value is 0, and the sign is that of the perturbed one
};

/// A displacement by the tie rule: of coordinate 0, 1 or 2 of a vertex, by a power of eps.
struct MovedCoordinate {
  Side side = Side::E;
  Index vertex = 0;
  int coordinate = 0;
  bool operator==(const MovedCoordinate&) const = default;
};

struct Sign {
  Predicate predicate = Predicate::orientation;
  std::vector<Feature> of;  ///< orientation: the vertices a, b, c, d; else the line or barycentre, then the other one
  int exact = 0;            ///< before any tie is broken
  Stage stage = Stage::filter;
  int decided = 0;  ///< as the answer has it; 0 where no rule breaks the tie: `facing` and `distance_along_line`
  /// Orientation by the tie rule: the first term of the perturbed determinant that is not 0 is the product of these
  /// displacements, greatest first, times its coefficient.
  std::vector<MovedCoordinate> term;
  /// Side of a line by the tie rule: 1 where the barycentre's shift d (p1 - p0) decides, 2 where d^2 (p2 - p0) does.
  int shift = 0;
};

}  // namespace pcm::compare
