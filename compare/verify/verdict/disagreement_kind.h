// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace pcm::compare {

/// What can disagree, and by that what is held. Discrete facts must be equal; values must lie within the bounds of
/// rounding_bounds.h and clipped_bounds.h on the oracle's answer to the rounded problem, unless said.
enum class Kind : std::uint8_t {
  failure,              ///< engine or oracle threw
  touching,             ///< do the surfaces cross?
  nested,               ///< does a component lie in the other body without crossing?
  ambiguous,            ///< is a set of faces of an open pairing labelled both ways?
  polygon_count,        ///< number of intersection polygons
  polygon_cycle,        ///< a polygon's crossings, their order, its start, or whether it is closed
  patches,              ///< number of contact patches, or which polygon belongs to which
  intersected_faces,    ///< set of faces in a crossing pair, of either surface
  inner_faces,          ///< set of uncrossed faces inside the other body (nested included), of either surface
  undefined_areas,      ///< number of faces whose clipped area an open border leaves undefined
  elements,             ///< set of contact elements as (master, master face, slave face); clipped: of those that are
                        ///< no slivers
  too_deep,             ///< number of faces whose penetration line leaves the master first
  crossing_position,    ///< position of a crossing
  area,                 ///< clipped active area of either surface
  vector_area,          ///< its vector area
  volume,               ///< volume of the intersection
  element_area,         ///< A_k
  element_penetration,  ///< u_k
  element_position,     ///< C_k
  element_normal,       ///< n_k
  element_velocity,     ///< v_n or v_t
  element_force,        ///< F_n, F_t or the force on E
  penetration,          ///< greatest penetration
  exceeded,             ///< whether the answer's own one exceeds the law's bound
  has_volume,           ///< whether there is a volume
  force,                ///< force on E
  torque,               ///< torque on E about Mf
  tangent,              ///< derivatives of force and torque by pose and velocity
  sums,                 ///< force, torque, greatest penetration or count against the answer's own elements
  statistics,           ///< the summary against the answer's own elements
  bound,                ///< the engine's own bound on the error of force or torque against the exact problem broken or
                        ///< infinite, or a flip it did not announce
  penetration_bound,    ///< its bounds on the exact problem's greatest penetration broken, or at odds with its own one
  paths,                ///< an answer by another call route (asks.h) differs in a bit
  work,                 ///< counters that contradict the answer or each other
  history,              ///< the oracle answers the exact problem otherwise when it is asked afresh
};

inline constexpr int kKinds = static_cast<int>(Kind::history) + 1;

/// The kind as a word of the tables, e.g. "polygon cycle".
std::string_view name(Kind kind);

}  // namespace pcm::compare
