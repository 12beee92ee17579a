// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tuple>

#include "tests/reference/brute_force/brute_force.h"

namespace pcm::brute_force {

/// All that is discrete in an answer: what two rooms must agree on to the last item on the same problem.
struct Combinatorics {
  bool touching = false;
  bool nested = false;
  bool ambiguous = false;
  Index patches = 0;
  Index undefined_areas = 0;
  Index too_deep = 0;
  std::vector<Polygon> polygons;
  std::array<std::vector<Index>, 2> intersected;
  std::array<std::vector<Index>, 2> inner;
  std::vector<std::tuple<Side, Index, Index>> elements;  ///< master, its face, the slave's face
};

Combinatorics combinatorics_of(const Answer& answer);

/// What differs, a line each; empty where nothing does.
std::string difference(const Combinatorics& truth, const Combinatorics& subject);

}  // namespace pcm::brute_force
