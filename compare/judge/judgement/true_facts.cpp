// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/true_facts.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "compare/verify/verdict/element_key.h"

namespace pcm::compare {

Wanted wanted_for(const GivenAnswer& answer) {
  const bool force = answer.element_count || answer.elements || answer.force_Me || answer.torque_Me;
  const bool areas = answer.E.area || answer.F.area || answer.volume;
  return {.polygons = true, .areas = areas, .force = force, .elements = force};
}

std::vector<Index> active_faces(const std::vector<Index>& intersected, const std::vector<Index>& inner) {
  std::vector<Index> active;
  std::merge(intersected.begin(), intersected.end(), inner.begin(), inner.end(), std::back_inserter(active));
  return active;
}

std::vector<FacePair> true_crossing_pairs(const Question& question, const reference::Answer& truth) {
  std::vector<reference::Crossing> crossings;
  for (const reference::Polygon& polygon : truth.polygons)
    crossings.insert(crossings.end(), polygon.points.begin(), polygon.points.end());
  return crossing_pairs(question.E, question.F, crossings);
}

bool same_discrete_facts(const reference::Answer& a, const reference::Answer& b) {
  const auto same_point = [](const reference::Crossing& x, const reference::Crossing& y) {
    return std::tie(x.edge_side, x.edge, x.face) == std::tie(y.edge_side, y.edge, y.face);
  };
  const auto same_polygon = [&](const reference::Polygon& x, const reference::Polygon& y) {
    return x.closed == y.closed &&
           std::equal(x.points.begin(), x.points.end(), y.points.begin(), y.points.end(), same_point);
  };
  return a.touching == b.touching && a.E.intersected == b.E.intersected && a.F.intersected == b.F.intersected &&
         a.E.inner == b.E.inner && a.F.inner == b.F.inner &&
         std::equal(a.polygons.begin(), a.polygons.end(), b.polygons.begin(), b.polygons.end(), same_polygon) &&
         same_elements(a.elements, b.elements);
}

}  // namespace pcm::compare
