// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pcm/contact.h"
#include "pcm/pcm.h"

/// From what the engine answers to what C programs read: plain structs, number by number.
namespace pcm::c {

inline void copy(const Eigen::Vector3d& from, double (&to)[3]) {
  Eigen::Map<Eigen::Vector3d>{to} = from;
}

pcm_answer answer_of(const fast::Contact& contact);

pcm_element entry_of(const fast::Element& element);
pcm_polygon entry_of(const fast::Polygon& polygon);
pcm_crossing entry_of(const fast::Crossing& crossing);
inline std::int32_t entry_of(Index face) {
  return face;
}

}  // namespace pcm::c
