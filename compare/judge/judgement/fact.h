// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace pcm::compare {

/// What an answer may say, and what is judged each by itself. Discrete facts must be the oracle's answer to the rounded
/// problem, values within a bound of it (tolerances.h). What is said of E and of F is one fact.
enum class Fact : std::uint8_t {
  touching,             ///< do the surfaces cross?
  crossing_pairs,       ///< the set of pairs of faces that cross
  intersected_faces,    ///< the set of faces in such a pair
  inner_faces,          ///< the set of uncrossed faces inside the other body
  active_faces,         ///< both together
  polygons,             ///< number of intersection polygons
  closed_polygons,      ///< number of closed ones
  elements,             ///< the set of contact elements, or their number
  area,                 ///< clipped active area
  volume,               ///< of the intersection
  element_area,         ///< A_k of every element that both sides have
  element_penetration,  ///< u_k of these
  force,                ///< on E
  torque,               ///< on E about Mf
};

inline constexpr std::size_t kFacts = 14;

inline constexpr std::array<std::string_view, kFacts> kFactNames = {
    "touching",     "crossing pairs", "intersected faces", "inner faces",
    "active faces", "polygons",       "closed polygons",   "elements",
    "area",         "volume",         "element area",      "element penetration",
    "force",        "torque"};

inline std::string_view name(Fact fact) {
  return kFactNames[static_cast<std::size_t>(fact)];
}

/// Whether it is a set, of which members may be lost or spurious.
inline bool is_set(Fact fact) {
  return (fact >= Fact::crossing_pairs && fact <= Fact::active_faces) || fact == Fact::elements;
}

/// Whether it is a value, and not a discrete fact.
inline bool is_value(Fact fact) {
  return fact >= Fact::area;
}

}  // namespace pcm::compare
