// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/rounding_bounds.h"
#include "fast/contact.h"
#include "reference/answer.h"

/// The comparison by contract (DESIGN sections 2 and 3). `true` in a name is the oracle's, `subj` the engine's.
namespace pcm::compare {

/// What can disagree with the oracle's answer to the rounded problem. Discrete facts must be equal; values must lie
/// within the bounds of rounding_bounds.h.
enum class Kind : std::uint8_t {
  failure,            ///< engine or oracle threw
  touching,           ///< do the surfaces cross?
  nested,             ///< does a component lie in the other body without crossing?
  ambiguous,          ///< is a set of faces of an open pairing labelled both ways?
  polygon_count,      ///< number of intersection polygons
  polygon_cycle,      ///< a polygon's crossings, their order, its start, or whether it is closed
  patches,            ///< number of contact patches, or which polygon belongs to which
  intersected_faces,  ///< set of faces in a crossing pair, of either surface
  inner_faces,        ///< set of uncrossed faces inside the other body (nested included), of either surface
  undefined_areas,    ///< number of faces whose clipped area an open border leaves undefined
  elements,           ///< set of contact elements as (master, master face, slave face)
  too_deep,           ///< number of faces whose penetration line leaves the master first
  crossing_position,  ///< position of a crossing
  area,               ///< clipped active area of either surface, outside the oracle's [open, closed] as well
  vector_area,        ///< its vector area
  volume,             ///< volume of the intersection, or whether it exists
  element_values,     ///< an element's area, penetration, position or force
  penetration,        ///< greatest penetration, or whether it exceeds the law's bound
  force,              ///< force on E
  torque,             ///< torque on E about Mf
  bound,              ///< the engine's own bound on the error of force or torque broken, or a flip it did not announce
};

inline constexpr int kKinds = 21;

/// The kind as a word of the tables, e.g. "polygon cycle".
std::string_view name(Kind kind);

/// One disagreement: its kind and what each side says.
struct Disagreement {
  Kind kind = Kind::failure;
  std::string text;
};

/// Every disagreement between the engine and the oracle's answer to the rounded problem, at most one of each kind, in
/// the order of the kinds. Where discrete facts disagree, the values that hang on them are not compared. Elements of
/// the clipped scheme are not held one by one, for slivers may come and go: there the engine's own bounds hold force
/// and torque.
std::vector<Disagreement> disagreements(const Question& question, const fast::Contact& subj,
                                        const reference::Answer& true_rounded);

/// Breaches of the engine's own bounds, where it gave any: by a component of force or torque, by the greatest
/// penetration, or by an element that the exact problem has and the rounded one has not (or the reverse) while the
/// engine calls its elements certain. At most one, of kind `bound`.
std::vector<Disagreement> broken_bounds(const Question& question, const fast::Contact& subj,
                                        const reference::Answer& true_rounded, const reference::Answer& true_exact);

/// Rounding errors of the engine against the oracle's answer to the exact problem, relative as DESIGN section 3 states
/// them and then divided by S/p: the measure is 1e-13. Absent where there is nothing to relate to: no contact, areas of
/// coplanar faces that are an interval, elements of a pose that is `flipped`.
struct RelativeErrors {
  std::optional<double> area;          ///< the worse of both surfaces, relative to the area
  std::optional<double> vector_area;   ///< likewise, relative to the area
  std::optional<double> volume;        ///< relative to area times p
  std::optional<double> penetration;   ///< greatest penetration, relative to itself
  std::optional<double> force;         ///< relative to the sum of |F_k|
  std::optional<double> torque;        ///< relative to the sum of |C_k - r| |F_k|
  std::optional<double> force_bound;   ///< the engine's own bounds, stated like the errors they bound; absent where
  std::optional<double> torque_bound;  ///< infinite
};

/// True where the two problems' elements cannot be told to be the same: the oracle does not certify the pose, or the
/// sets of elements differ.
bool flipped(const reference::Answer& true_rounded, const reference::Answer& true_exact);

/// How thick the contact is: p, by which rounding errors are stated. Twice the volume of a solid over its surface: the
/// width of a long thin one, the thickness of a flat one. Closed surfaces: of the intersection, the sum of both clipped
/// areas being its surface. A surface that is open bounds no volume: there it is of what the elements integrate over,
/// prisms of volume A_k u_k between two faces of area A_k, with a wall of height u (the mean of the u_k over the A_k)
/// all along the intersection polygons. That bounds the patch's width as well as its depth, for a patch that the border
/// has left but a corner of may be a thousand times deeper than wide. 0 without elements.
double mean_thickness(const reference::Answer& truth);

RelativeErrors relative_errors(const Question& question, const fast::Contact& subj, const reference::Answer& true_exact,
                               bool pose_is_flipped);

}  // namespace pcm::compare
