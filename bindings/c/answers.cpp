// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings/c/answers.h"

#include <vector>

namespace pcm::c {

namespace {

template <class T>
std::int32_t length(const std::vector<T>& list) {
  return static_cast<std::int32_t>(list.size());
}

std::int32_t side_of(Side side) {
  return side == Side::E ? PCM_E : PCM_F;
}

pcm_active_area active_area_of(const fast::ActiveArea& area) {
  pcm_active_area result{};
  result.area = area.area;
  copy(area.vector_area_Me, result.vector_area_Me);
  result.intersected = length(area.intersected);
  result.inner = length(area.inner);
  return result;
}

pcm_bound bound_of(const fast::ForceBound& bound) {
  pcm_bound result{};
  copy(bound.force_Me, result.force_Me);
  copy(bound.torque_Me, result.torque_Me);
  result.penetration_at_least = bound.penetration_at_least;
  result.penetration_at_most = bound.penetration_at_most;
  result.given = 1;
  result.flipped = bound.flipped;
  return result;
}

pcm_statistics statistics_of(const fast::Statistics& statistics) {
  pcm_statistics result{};
  result.patch_area = statistics.patch_area;
  result.mean_penetration = statistics.mean_penetration;
  result.max_pressure = statistics.max_pressure;
  result.mean_pressure = statistics.mean_pressure;
  result.max_normal_velocity = statistics.max_normal_velocity;
  result.max_tangential_velocity = statistics.max_tangential_velocity;
  copy(statistics.centre_of_pressure_Me, result.centre_of_pressure_Me);
  return result;
}

}  // namespace

pcm_answer answer_of(const fast::Contact& contact) {
  pcm_answer result{};
  result.size = sizeof result;
  result.touching = contact.touching;
  result.nested = contact.nested;
  result.ambiguous = contact.ambiguous;
  result.has_volume = contact.has_volume;
  result.penetration_exceeded = contact.penetration_exceeded;
  result.too_deep = contact.too_deep;
  result.undefined_areas = contact.undefined_areas;
  result.patches = contact.patches;
  result.polygons = length(contact.polygons);
  result.crossings = length(contact.crossings);
  result.element_count = contact.element_count;
  result.elements = length(contact.elements);
  copy(contact.force_Me, result.force_Me);
  copy(contact.torque_Me, result.torque_Me);
  result.max_penetration = contact.max_penetration;
  result.volume = contact.volume;
  result.E = active_area_of(contact.E);
  result.F = active_area_of(contact.F);
  if (contact.bound) result.bound = bound_of(*contact.bound);
  result.statistics = statistics_of(contact.statistics);
  return result;
}

pcm_element entry_of(const fast::Element& element) {
  pcm_element result{};
  result.master = side_of(element.master);
  result.master_face = element.master_face;
  result.slave_face = element.slave_face;
  result.area = element.area;
  result.penetration = element.penetration;
  result.normal_velocity = element.normal_velocity;
  result.tangential_velocity = element.tangential_velocity;
  result.normal_force = element.normal_force;
  result.tangential_force = element.tangential_force;
  copy(element.normal_Me, result.normal_Me);
  copy(element.position_Me, result.position_Me);
  copy(element.force_Me, result.force_Me);
  return result;
}

pcm_polygon entry_of(const fast::Polygon& polygon) {
  return {polygon.closed, polygon.first, polygon.count, polygon.patch};
}

pcm_crossing entry_of(const fast::Crossing& crossing) {
  pcm_crossing result{};
  result.edge_side = side_of(crossing.edge_side);
  result.edge[0] = crossing.edge[0];
  result.edge[1] = crossing.edge[1];
  result.face = crossing.face;
  copy(crossing.position_Me, result.position_Me);
  return result;
}

}  // namespace pcm::c
