// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/answer.h"
#include "tests/reference/brute_force/combinatorics.h"

namespace pcm::brute_force {

/// The oracle's answer in the twin's words.
inline Combinatorics combinatorics_of(const reference::Answer& answer) {
  Combinatorics result;
  result.touching = answer.touching;
  result.nested = answer.nested;
  result.ambiguous = answer.ambiguous;
  result.patches = answer.patches;
  result.undefined_areas = answer.undefined_areas;
  result.too_deep = answer.too_deep;
  for (const reference::Polygon& polygon : answer.polygons) {
    Polygon& copy = result.polygons.emplace_back();
    copy.closed = polygon.closed;
    copy.patch = polygon.patch;
    for (const reference::Crossing& c : polygon.points) copy.points.push_back({c.edge_side, c.edge, c.face});
  }
  result.intersected = {answer.E.intersected, answer.F.intersected};
  result.inner = {answer.E.inner, answer.F.inner};
  for (const reference::Element& element : answer.elements)
    result.elements.emplace_back(element.master, element.master_face, element.slave_face);
  return result;
}

}  // namespace pcm::brute_force
