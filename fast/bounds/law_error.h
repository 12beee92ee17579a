// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "fast/bounds/element_error.h"
#include "fast/force/force_problem.h"
#include "pcm/contact.h"

/// How far the force law (14), (15), (18), (20) carries the errors of an element: all that the bounds know of the
/// formulas of fast/law/element_force.h.
namespace pcm::fast {

/// What underflows, in the engine or in a bound, is off by 2^-1075 besides; no more than 2^5 such products make up a
/// number that is multiplied on, or that is divided by a velocity. What is multiplied on may be as great as any double:
/// so these are told for each product.
inline constexpr double kUnderflow = 0x1p-1070;

/// A computed number, as its absolute value, and how far it may be from the true one.
struct Uncertain {
  double size = 0;
  double error = 0;
  double greatest() const { return size + error; }
};

/// F_n (18) of an element whose approach velocity is off by `v_n_error` m/s.
Uncertain normal_force_error(const ForceProblem& problem, const Element& element, const ElementError& error,
                             double v_n_error);

/// Errors of the friction force, N.
struct FrictionErrors {
  double along = 0;   ///< by F_n's error, in the direction of friction
  double beside = 0;  ///< in any direction
};

/// Of an element that slips at v_t m/s, each component off so that their errors sum up to `slip_error` m/s.
FrictionErrors friction_error(const ContactLaw& law, const Uncertain& F_n, double v_t, double slip_error);

/// |F_n| of any element of this area, m^2, penetration u_k, m, and speed, m/s, but for roundings. N.
double greatest_normal_force(const ForceProblem& problem, double area, double u_k, double speed);

/// What passes between elements is less than this share of an element, or it counts in full.
inline constexpr double kGreatestShare = 0x1p-12;

/// dF_n / dV, N / m^3, and dF_n / dA, N / m^2, at fixed velocities; V is the integral of the clamped depth.
struct NormalRates {
  double per_volume = 0;
  double per_area = 0;
};

/// Roundings of an element's rates, of themselves: those of the stiffness (3), or of the damping's product and quotient
/// with the transition depth (2), the sum of both 1, the direction's quotient 1, the product with it 1. Where terms
/// cancel, in that sum or between normal force and friction, roundings are greater than that, but no greater than the
/// element's own force has them of as great terms (force_error); of that force less than kGreatestShare passes, so they
/// are less than that share of its error, and within kGrowth. The lever's single rounding is less. Rates and lever of
/// the first element have none: the sums are off by no more whichever constants are taken from all rates and levers.
inline constexpr double kRateRoundings = 6;

/// Where F_n is surely linear in both, which it is but where damping begins to fade or F_n to vanish, in both problems
/// and between them, and what may pass is little (clipped scheme).
std::optional<NormalRates> surely_linear_rates(const ForceProblem& problem, const Element& element,
                                               const ElementError& error);

}  // namespace pcm::fast
