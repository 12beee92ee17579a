// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pcm/inputs.h"

/// The force law, (12) to (20), in the engine; (14), (15), (18), (20) are in fast/law/element_force.h, which says what
/// else changes with them.
///
/// Parts of the engine's entry points, which hold a `DefaultFloatingPoint`: they compute in the caller's floating-point
/// environment.
namespace pcm::fast {

/// Throws BadInput, naming the parameter and its range, where the law has none of the values PCM section 7 allows.
void require_valid(const ContactLaw& law);

/// Throws BadInput where anything is not finite or greater than 2^700.
void require_valid(const Velocity& velocity);

/// Throws BadInput where the pose is no rotation to 1e-9, where anything is not finite or r is beyond
/// kGreatestCoordinate. Returns the pose's orthogonality error (fast/base/geometry.h).
double require_valid(const Pose& pose, const Velocity& velocity);

/// How stiff both layers are together, and how they share the penetration.
struct SeriesStiffness {
  double c_l = 0;           ///< (12), N/m^3
  double shift_from_E = 0;  ///< c_F / (c_E + c_F): where C_k lies between E's face (0) and F's (1), master E (13)
  double shift_from_F = 0;  ///< c_E / (c_E + c_F), master F

  explicit SeriesStiffness(const ContactLaw& law);
};

/// Normal and tangential force of an element, master's point of view.
struct ElementForce {
  double normal = 0;      ///< F_n (18), N
  double tangential = 0;  ///< F_t (20), N
};

/// (14), (15), (18), (20) for an element of area A_k m^2, penetration u_k >= 0 m, approach velocity v_n and slip
/// velocity v_t m/s.
ElementForce element_force(const ContactLaw& law, double c_l, double area, double penetration, double v_n, double v_t);

}  // namespace pcm::fast
