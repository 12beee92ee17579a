// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tuple>

#include "tests/reference/brute_force/answer.h"

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

/// What is discrete in any room's answer: their members have the same names, but each has a way of its own to keep the
/// crossings of a polygon, which `crossings_of` gives.
template <class AnyAnswer, class CrossingsOf>
Combinatorics combinatorics_of(const AnyAnswer& answer, const CrossingsOf& crossings_of) {
  Combinatorics result;
  result.touching = answer.touching;
  result.nested = answer.nested;
  result.ambiguous = answer.ambiguous;
  result.patches = answer.patches;
  result.undefined_areas = answer.undefined_areas;
  result.too_deep = answer.too_deep;
  for (const auto& polygon : answer.polygons) {
    Polygon& copy = result.polygons.emplace_back();
    copy.closed = polygon.closed;
    copy.patch = polygon.patch;
    for (const auto& c : crossings_of(polygon)) copy.points.push_back({c.edge_side, c.edge, c.face});
  }
  result.intersected = {answer.E.intersected, answer.F.intersected};
  result.inner = {answer.E.inner, answer.F.inner};
  for (const auto& element : answer.elements)
    result.elements.emplace_back(element.master, element.master_face, element.slave_face);
  return result;
}

Combinatorics combinatorics_of(const Answer& answer);

/// What differs, a line each; empty where nothing does.
std::string difference(const Combinatorics& truth, const Combinatorics& subj);

}  // namespace pcm::brute_force
