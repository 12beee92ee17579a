// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <vector>

#include "bindings/c/answers.h"
#include "pcm/contact.h"
#include "pcm/pcm.h"

/// Plain structs that are rows of NumPy's structured arrays; elements and crossings are those of the C interface.
namespace pcm::python {

/// An answer without its lists.
struct AnswerRow {
  bool touching, nested, ambiguous, has_volume, penetration_exceeded, flipped;
  std::int32_t too_deep, undefined_areas, patches, element_count;
  double force_Me[3], torque_Me[3];
  double max_penetration, volume, area_E, area_F;
  double vector_area_E_Me[3], vector_area_F_Me[3];
  double force_bound_Me[3], torque_bound_Me[3];
  double penetration_at_least, penetration_at_most;
  double patch_area, mean_penetration, max_pressure, mean_pressure, max_normal_velocity, max_tangential_velocity;
  double centre_of_pressure_Me[3];
};

struct PolygonRow {
  bool closed;
  std::int32_t first, count, patch;
};

AnswerRow row_of(const fast::Contact& contact);

inline PolygonRow row_of(const fast::Polygon& polygon) {
  return {polygon.closed, polygon.first, polygon.count, polygon.patch};
}
inline pcm_element row_of(const fast::Element& element) {
  return c::entry_of(element);
}
inline pcm_crossing row_of(const fast::Crossing& crossing) {
  return c::entry_of(crossing);
}
inline Index row_of(Index face) {
  return face;
}

/// A list as an array.
template <class Entry>
auto array_of_rows(const std::vector<Entry>& list) {
  using Row = decltype(row_of(list.front()));
  pybind11::array_t<Row> array(static_cast<pybind11::ssize_t>(list.size()));
  Row* to = array.mutable_data();
  for (const Entry& entry : list) *to++ = row_of(entry);
  return array;
}

/// Tells NumPy of these structs; once, before the first array is made.
void register_rows();

}  // namespace pcm::python
