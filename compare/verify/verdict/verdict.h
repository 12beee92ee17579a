// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "compare/verify/bounds/question.h"
#include "compare/verify/verdict/checks.h"
#include "pcm/contact.h"
#include "reference/vocabulary/answer.h"

/// The comparison by contract (DESIGN sections 2 and 3). `true` in a name is the oracle's, `subj` the engine's.
namespace pcm::compare {

/// Holds every field of the engine's whole answer (Wanted as it is by default) against the oracle's answer to the
/// rounded problem and against the answer's own elements. Where discrete facts disagree, the values that depend on them
/// are not held. Clipped elements are held one by one but for slivers, which may come and go (clipped_bounds.h).
Checks hold_answer(const Question& question, const fast::Contact& subj, const reference::Answer& true_rounded);

/// What disagrees there, at most one of each kind, in the order of the kinds.
std::vector<Disagreement> disagreements(const Question& question, const fast::Contact& subj,
                                        const reference::Answer& true_rounded);

/// Breaches of the engine's own bounds, where it gave any. Kind `bound`: by a component of force or torque, by an
/// infinite bound though no number is near the end of the range of doubles, or by an element that the exact problem has
/// and the rounded one has not (or the reverse) while the engine calls its elements certain. Kind `penetration_bound`:
/// by the greatest penetration of the exact problem, or by a lower bound that the engine's own greatest penetration, or
/// its upper bound, does not reach. Kind `penetration`: in the clipped scheme, by the engine's own greatest depth,
/// where no sliver may make it so. Nothing without a bound.
Checks broken_bounds(const Question& question, const fast::Contact& subj, const reference::Answer& true_rounded,
                     const reference::Answer& true_exact);

/// Holds the exact problem's answer against that of an oracle that was asked nothing before: everything alike.
Checks hold_history(const reference::Answer& true_exact, const reference::Answer& true_afresh);

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
