// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "compare/verify/bounds/question.h"
#include "compare/verify/bounds/uncertain_number.h"
#include "reference/vocabulary/answer.h"

/// The contact law once more, in plain doubles, for elements that the oracle does not have, and how far such an
/// evaluation, or the engine's, may be off (PCM section 7).
namespace pcm::compare {

/// c_l (12).
double series_stiffness(const ContactLaw& law);

/// Which part of its penetration an element lies from its master face towards the slave (13): c_F / (c_E + c_F) for
/// master E. 2 roundings.
double share_of_penetration(const ContactLaw& law, Side master);

/// The element with the velocities (16), (17), (19) and forces (14), (15), (18), (20), (21) that its area, penetration,
/// unit normal and position make. Each is a straightforward evaluation, so off by no more than bounds_after_law of no
/// geometry errors.
reference::Element after_law(const Question& question, reference::Element element);

/// Derivatives of F_n (18) and F_t (20), where a kink of the law may be near those of either side.
struct LawSlopes {
  UncertainNumber normal_by_depth, normal_by_approach;                              ///< dF_n/du_k, dF_n/dv_n
  UncertainNumber tangential_by_depth, tangential_by_approach, tangential_by_slip;  ///< dF_t/du_k, dF_t/dv_n, dF_t/dv_t
  UncertainNumber tangential_over_slip;                                             ///< F_t / v_t, at rest its limit
};
LawSlopes law_slopes(const ContactLaw& law, const UncertainNumber& area, const UncertainNumber& penetration,
                     const UncertainNumber& v_n, const UncertainNumber& v_t);

/// The greatest |F_k|, N, of an element of this area, m^2, penetration, m, and speed |v_k|, m/s: (1 + mu) A_k (c_l u_k
/// + d_l |v_k|), but for roundings.
double greatest_force(const ContactLaw& law, double area, double penetration, double speed);

/// How far what an element brings to the force law may be off.
struct GeometryErrors {
  double area = 0;         ///< of A_k, m^2
  double penetration = 0;  ///< of u_k before clamping, m
  /// Of A_k u_k after clamping, where more is known of it than what the errors of both factors make, m^3.
  double volume = std::numeric_limits<double>::infinity();
  double foot = 0;    ///< of C_e or the centre of pressure, m
  double normal = 0;  ///< of n_k, at most 2
};

/// Bounds for one contact element: how far a right engine's doubles may be from the oracle's.
struct ElementBounds {
  double area = 0;                 ///< m^2
  double penetration = 0;          ///< m, after clamping
  double depth = 0;                ///< m, of the penetration before clamping
  double position = 0;             ///< m, length of the difference
  double normal = 0;               ///< length of the difference
  double normal_velocity = 0;      ///< m/s
  double tangential_velocity = 0;  ///< m/s
  double normal_force = 0;         ///< N
  double tangential_force = 0;     ///< N
  double force = 0;                ///< N, length of the difference
  double torque = 0;               ///< N m, length of the difference
};

/// What the law (13) to (22) makes of the errors of an element's geometry: running error bounds, each term a number of
/// roundings of a straightforward evaluation times its condition. `truth` is the oracle's element.
ElementBounds bounds_after_law(const Question& question, const reference::Element& truth, const GeometryErrors& errors);

/// Where both sides round as one of them does here.
ElementBounds twice(ElementBounds bounds);

}  // namespace pcm::compare
