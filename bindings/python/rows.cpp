// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings/python/rows.h"

namespace pcm::python {

namespace {

using c::copy;

void add_bound(const fast::ForceBound& bound, AnswerRow& row) {
  row.flipped = bound.flipped;
  copy(bound.force_Me, row.force_bound_Me);
  copy(bound.torque_Me, row.torque_bound_Me);
  row.penetration_at_least = bound.penetration_at_least;
  row.penetration_at_most = bound.penetration_at_most;
}

void add_statistics(const fast::Statistics& statistics, AnswerRow& row) {
  row.patch_area = statistics.patch_area;
  row.mean_penetration = statistics.mean_penetration;
  row.max_pressure = statistics.max_pressure;
  row.mean_pressure = statistics.mean_pressure;
  row.max_normal_velocity = statistics.max_normal_velocity;
  row.max_tangential_velocity = statistics.max_tangential_velocity;
  copy(statistics.centre_of_pressure_Me, row.centre_of_pressure_Me);
}

}  // namespace

AnswerRow row_of(const fast::Contact& contact) {
  AnswerRow row{};
  row.touching = contact.touching;
  row.nested = contact.nested;
  row.ambiguous = contact.ambiguous;
  row.has_volume = contact.has_volume;
  row.penetration_exceeded = contact.penetration_exceeded;
  row.too_deep = contact.too_deep;
  row.undefined_areas = contact.undefined_areas;
  row.patches = contact.patches;
  row.element_count = contact.element_count;
  copy(contact.force_Me, row.force_Me);
  copy(contact.torque_Me, row.torque_Me);
  row.max_penetration = contact.max_penetration;
  row.volume = contact.volume;
  row.area_E = contact.E.area;
  row.area_F = contact.F.area;
  copy(contact.E.vector_area_Me, row.vector_area_E_Me);
  copy(contact.F.vector_area_Me, row.vector_area_F_Me);
  if (contact.bound) add_bound(*contact.bound, row);
  add_statistics(contact.statistics, row);
  return row;
}

void register_rows() {
  PYBIND11_NUMPY_DTYPE(AnswerRow, touching, nested, ambiguous, has_volume, penetration_exceeded, flipped, too_deep,
                       undefined_areas, patches, element_count, force_Me, torque_Me, max_penetration, volume, area_E,
                       area_F, vector_area_E_Me, vector_area_F_Me, force_bound_Me, torque_bound_Me,
                       penetration_at_least, penetration_at_most, patch_area, mean_penetration, max_pressure,
                       mean_pressure, max_normal_velocity, max_tangential_velocity, centre_of_pressure_Me);
  PYBIND11_NUMPY_DTYPE(PolygonRow, closed, first, count, patch);
  PYBIND11_NUMPY_DTYPE(pcm_crossing, edge_side, edge, face, position_Me);
  PYBIND11_NUMPY_DTYPE(pcm_element, master, master_face, slave_face, area, penetration, normal_velocity,
                       tangential_velocity, normal_force, tangential_force, normal_Me, position_Me, force_Me);
}

}  // namespace pcm::python
